"""Error against run time: scenes.py and methods.py are the two tables, errors.py the definitions, page.py the end."""
