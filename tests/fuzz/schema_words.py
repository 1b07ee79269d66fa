"""Prints the keys and the choices of a JSON Schema as a dictionary for libFuzzer."""

import json
import sys


def words(node):
    """Yields each property's name and each enumerated or constant text below `node`."""
    if isinstance(node, dict):
        yield from node.get("properties", {})
        yield from (value for value in node.get("enum", []) if isinstance(value, str))
        if isinstance(node.get("const"), str):
            yield node["const"]
    if isinstance(node, (dict, list)):
        for child in node.values() if isinstance(node, dict) else node:
            yield from words(child)


with open(sys.argv[1], encoding="utf-8") as file:
    found = sorted(set(words(json.load(file))))
for word in found:
    print('"\\"' + word.replace("\\", "\\\\").replace('"', '\\"') + '\\""')
