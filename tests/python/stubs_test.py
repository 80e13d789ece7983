"""The type stubs say what the module has, no more and no less, and everything in it has a docstring.

    stubs_test.py STUBS
"""
import ast
import re
import sys
from pathlib import Path

import ritz

ALIASES = {"Floats", "Indices", "File", "Integrator"}  # names of types, which exist for the stubs alone
OF_PYTHON = set(dir(object)) | set(dir(ValueError)) | set(dir(ArithmeticError)) | {"__module__", "__weakref__"}


def arguments(function):
    """Names of the arguments of a function of the stubs, self too."""
    given = function.args
    return [argument.arg for argument in given.posonlyargs + given.args + given.kwonlyargs]


def documented(function):
    """The same of a function of the module, as the first line of its docstring has them."""
    inside = re.match(r"\w+\((.*)\) -> ", function.__doc__).group(1)
    return re.findall(r"(?:^|, )(\w+): ", inside)


def compare(where, stubs, real):
    """Complaints about a module or class and what the stubs say of it."""
    said = {}
    for node in stubs:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            said[node.name] = node
        elif isinstance(node, ast.AnnAssign):
            said[node.target.id] = node
    there = {name for name in vars(real) if name not in OF_PYTHON or name in said}
    if isinstance(real, type(ritz)):
        there -= {"__name__", "__package__", "__loader__", "__spec__", "__file__"}
    for name in sorted(set(said) ^ there):
        yield f"{where}{name} is {'only in the stubs' if name in said else 'not in the stubs'}"
    for name in sorted(set(said) & there):
        node, value = said[name], getattr(real, name)
        if isinstance(node, ast.ClassDef):
            yield from compare(f"{name}.", node.body, value)
        elif isinstance(node, ast.FunctionDef) and not node.decorator_list and not name.startswith("__"):
            if arguments(node) != documented(value):
                yield f"{where}{name} takes {documented(value)}, and the stubs say {arguments(node)}"
        elif isinstance(node, ast.FunctionDef) and node.decorator_list and not isinstance(value, property):
            yield f"{where}{name} is no property"
        if isinstance(node, ast.AnnAssign) or name.startswith("__"):
            continue
        text = value.__doc__ or ""
        if len(text.split("\n\n", 1)[-1].strip()) < 3:
            yield f"{where}{name} has no docstring"


if __name__ == "__main__":
    tree = ast.parse(Path(sys.argv[1]).read_text()).body
    complaints = list(compare("", [node for node in tree if getattr(node, "name", "") not in ALIASES], ritz))
    print("\n".join(complaints) or "the stubs and the module agree")
    sys.exit(1 if complaints else 0)
