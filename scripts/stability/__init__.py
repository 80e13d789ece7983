"""The stability report: stiff and extreme scenes, each run through the real programs and held against its gate.

A row is a function `run(bench, length) -> [Figure, ...]`: it drives the programs in a folder of its own (bench.py) and
says what it measured (row.py). Rows of one kind stand in one file, which ends with their list ROWS; table.py lists all.
"""
