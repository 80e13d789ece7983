"""The layers as CMakeLists.txt states them: the table stands there and nowhere else."""
import re
from dataclasses import dataclass, field
from pathlib import Path


@dataclass
class Layer:
    folder: str
    installed: bool = False
    uses: set = field(default_factory=set)  # folders that may be included, its own too


def read(root):
    """Layers by folder; a folder compiled into two targets (FOLDER) counts once, with what both may use."""
    text = re.sub(r"#.*", "", (Path(root) / "CMakeLists.txt").read_text())
    calls = [call.split() for call in re.findall(r"ritz_layer\(([^)]*)\)", text)]
    folder_of = {words[0]: words[words.index("FOLDER") + 1] if "FOLDER" in words else words[0] for words in calls}
    layers = {}
    for words in calls:
        folder = folder_of[words[0]]
        layer = layers.setdefault(folder, Layer(folder, uses={folder}))
        layer.installed |= "INSTALLED" in words
        layer.uses |= {folder_of[used] for used in arguments(words, "USES")}
    return layers


def arguments(words, keyword):
    """What follows `keyword` up to the next keyword."""
    if keyword not in words:
        return []
    rest = words[words.index(keyword) + 1:]
    ends = [i for i, word in enumerate(rest) if word in ("INSTALLED", "FOLDER", "USES", "LIBRARIES")]
    return rest[:ends[0]] if ends else rest


def sources(root, folder):
    """Every header and source of a layer, sorted."""
    places = [Path(root) / "include" / "ritz" / folder, Path(root) / "src" / folder]
    return sorted(path for place in places for path in place.rglob("*") if path.suffix in (".hpp", ".cpp"))


def closure(layers, folder):
    """The folders whose headers a layer's own can reach: what it uses, what those use, and so on."""
    seen, todo = set(), [folder]
    while todo:
        name = todo.pop()
        if name not in seen:
            seen.add(name)
            todo.extend(layers[name].uses)
    return seen
