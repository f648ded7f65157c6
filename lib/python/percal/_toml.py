"""Dicts as TOML text, for the library's own readers."""

import json


def _value(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(one) for one in value) + "]"
    if hasattr(value, "item"):  # a number of numpy
        return repr(value.item())
    return json.dumps(str(value), ensure_ascii=False)


def _is_table_array(value):
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(one, dict) for one in value)


def _lines(table, path):
    inner = {key: value for key, value in table.items() if isinstance(value, dict)}
    arrays = {key: value for key, value in table.items() if _is_table_array(value)}
    for key, value in table.items():
        if key not in inner and key not in arrays and value is not None:
            yield f"{json.dumps(key)} = {_value(value)}"
    for key, value in inner.items():
        name = path + [json.dumps(key)]
        yield f"[{'.'.join(name)}]"
        yield from _lines(value, name)
    for key, tables in arrays.items():
        name = path + [json.dumps(key)]
        for one in tables:
            yield f"[[{'.'.join(name)}]]"
            yield from _lines(one, name)


def text_of(table):
    """A dict of texts, numbers, lists and dicts as TOML; what is None is left out."""
    return "\n".join(_lines(table, [])) + "\n"
