"""The driver finds what is planted in fuzz_planted, says it, and leaves the input that did it."""
import sys
import tempfile
from pathlib import Path

import programs
from program import BIN

HERE = Path(__file__).parent


def run(folder, *words):
    left = folder / "left"
    left.unlink(missing_ok=True)
    ran = programs.run(BIN / "fuzz_planted", "--each", "3", "--left", left, *words, folder=folder, code=None)
    return ran.code, ran.err, left.read_bytes() if left.exists() else None


def check(holds, what):
    if not holds:
        sys.exit(f"failed: {what}")


def finds_each_kind(folder):
    kinds = {"crash": "", "throw": "no InputError: some", "silent": "without a message", "hang": "too long",
             "memory": "MB for an input of 6 bytes"}
    for word, said in kinds.items():
        (folder / "input").write_text(word)
        code, text, left = run(folder, folder / "input")
        check(code not in (0, 2) and said in text, f"{word}: exit code {code}, {text}")
        check(left == word.encode(), f"{word}: left {left}")


def takes_what_is_good(folder):
    for text in ("good", "bad"):
        (folder / "input").write_text(text)
        code, said, left = run(folder, folder / "input")
        check(code == 0 and "1 inputs" in said and left is None, f"{text}: exit code {code}, {said}")


def searches(folder):
    """Words and nested repetition lead from a good seed to a crash; the same stream gives the same input."""
    words = HERE / "dictionaries" / "planted.dict"
    first, second = (run(folder, "--dictionary", words, "--inputs", "1000000", HERE / "corpus" / "planted")
                     for _ in range(2))
    check(first[0] not in (0, 2) and first[2], f"nothing was found: {first}")
    check(first == second, "another run found another input")
    other = run(folder, "--dictionary", words, "--stream", "2", "--inputs", "1000000", HERE / "corpus" / "planted")
    check(other[2] and other[2] != first[2], "another stream found the same input")


def refuses_wrong_orders(folder):
    (folder / "empty").mkdir()
    (folder / "bad.dict").write_text("no quotes\n")
    (folder / "input").write_text("good")
    for words, said in ((["--inputs"], "wants a value"), (["--what", "1"], "there is no --what"), ([folder / "empty"], "no input"),
                        (["--dictionary", folder / "bad.dict", folder / "input"], "bad.dict:1")):
        code, text, _ = run(folder, *words)
        check(code == 2 and said in text, f"{words}: exit code {code}, {text}")


with tempfile.TemporaryDirectory() as name:
    for number, test in enumerate((finds_each_kind, takes_what_is_good, searches, refuses_wrong_orders)):
        part = Path(name) / str(number)
        part.mkdir()
        test(part)
