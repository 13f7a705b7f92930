"""validate.py [--yaml-1.1] SCHEMA FILE...: what python3-jsonschema says of YAML files, as one JSON
object {file: null when valid, else its first error in words}.

PyYAML reads YAML 1.1, where `1e9` is a text, `yes` is true and `1_000` a number. carom and editors
read YAML 1.2, so scalars are resolved here by the core schema of YAML 1.2; with --yaml-1.1 they
are left to PyYAML.
"""
import json
import re
import sys

import jsonschema
import yaml


class Yaml12(yaml.SafeLoader):
    yaml_implicit_resolvers = {}

    def construct_mapping(self, node, deep=False):  # PyYAML keeps the last of equal keys
        names = [key.value for key, _ in node.value]
        if len(set(map(str, names))) < len(names):
            raise yaml.constructor.ConstructorError(None, None, "a key is there twice", node.start_mark)
        return super().construct_mapping(node, deep)

    def number(self, node):
        text = node.value.lower()
        if text.startswith(("0x", "0o")):
            return int(text, 0)
        if re.fullmatch(r"[-+]?[0-9]+", text):
            return int(text)
        return float(text.replace(".inf", "inf").replace(".nan", "nan"))

    def flag(self, node):
        return node.value.lower() == "true"


for tag, pattern, make in (
    ("null", r"~|null|Null|NULL|", lambda loader, node: None),
    ("flag", r"true|True|TRUE|false|False|FALSE", Yaml12.flag),
    ("number", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?|0o[0-7]+|0x[0-9a-fA-F]+"
     r"|[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)", Yaml12.number),
):
    Yaml12.add_implicit_resolver("!" + tag, re.compile(f"(?:{pattern})$"), None)
    Yaml12.add_constructor("!" + tag, make)


def verdict(validator, loader, path):
    try:
        with open(path, "rb") as file:
            scene = yaml.load(file, loader)
    except (yaml.YAMLError, RecursionError) as error:
        return "no YAML: " + str(error).replace("\n", " ")
    try:
        errors = sorted(validator.iter_errors(scene), key=lambda error: [str(step) for step in error.path])
    except RecursionError:
        return "no YAML: it holds itself"
    if not errors:
        return None
    place = ".".join(str(step) for step in errors[0].absolute_path)
    return f"{place}: {errors[0].message}"[:400]


arguments = sys.argv[1:]
loader = yaml.SafeLoader if arguments[0] == "--yaml-1.1" else Yaml12
if loader is yaml.SafeLoader:
    arguments = arguments[1:]
with open(arguments[0], encoding="utf-8") as file:
    schema = json.load(file)
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
print(json.dumps({path: verdict(validator, loader, path) for path in arguments[1:]}))
