"""A validator for as much of JSON Schema as docs/json.md uses; a word it does not know is an error, not a pass."""

from typing import Any

TYPES = {
    "object": dict,
    "array": list,
    "string": str,
    "integer": int,
    "number": (int, float),
    "boolean": bool,
    "null": type(None),
}
KNOWN = {
    "$defs", "$ref", "$schema", "additionalProperties", "const", "description", "enum", "items", "maxItems", "maximum",
    "minItems", "minimum", "oneOf", "pattern", "properties", "required", "title", "type",
}  # fmt: skip


def faults(
    value: Any, schema: dict[str, Any], root: dict[str, Any] | None = None, at: str = "$"
) -> list[str]:
    """List what in a value is not as its schema says."""
    root = schema if root is None else root
    unknown = set(schema) - KNOWN
    if unknown:
        raise ValueError(f"{at}: the validator does not know {sorted(unknown)}")
    if "$ref" in schema:
        target: Any = root
        for step in schema["$ref"].removeprefix("#/").split("/"):
            target = target[step]
        return faults(value, target, root, at)
    found = _simple(value, schema, at)
    if "oneOf" in schema:
        tried = [faults(value, option, root, at) for option in schema["oneOf"]]
        if sum(not wrong for wrong in tried) != 1:
            found.append(f"{at}: fits {sum(not wrong for wrong in tried)} of {len(tried)} shapes: {tried}")
    if isinstance(value, dict):
        known = schema.get("properties", {})
        found += [f"{at}: lacks {name!r}" for name in schema.get("required", []) if name not in value]
        if schema.get("additionalProperties") is False:
            found += [f"{at}: has {name!r}, which the schema lacks" for name in value if name not in known]
        for name, held in value.items():
            if name in known:
                found += faults(held, known[name], root, f"{at}.{name}")
            elif isinstance(schema.get("additionalProperties"), dict):
                found += faults(held, schema["additionalProperties"], root, f"{at}.{name}")
    if isinstance(value, list) and "items" in schema:
        for place, held in enumerate(value):
            found += faults(held, schema["items"], root, f"{at}[{place}]")
    return found


def _simple(value: Any, schema: dict[str, Any], at: str) -> list[str]:
    import re

    found = []
    wanted = schema.get("type", [])
    kinds = [wanted] if isinstance(wanted, str) else wanted
    is_bool = isinstance(value, bool)
    if kinds and not any(
        isinstance(value, TYPES[kind]) and (not is_bool or kind == "boolean") for kind in kinds
    ):
        found.append(f"{at}: expected {wanted}, got {value!r}")
    if "const" in schema and value != schema["const"]:
        found.append(f"{at}: expected {schema['const']!r}, got {value!r}")
    if "enum" in schema and value not in schema["enum"]:
        found.append(f"{at}: expected one of {schema['enum']}, got {value!r}")
    if "pattern" in schema and isinstance(value, str) and not re.search(schema["pattern"], value):
        found.append(f"{at}: {value!r} does not match {schema['pattern']}")
    number = isinstance(value, int | float) and not is_bool
    if "minimum" in schema and number and value < schema["minimum"]:
        found.append(f"{at}: {value} is less than {schema['minimum']}")
    if "maximum" in schema and number and value > schema["maximum"]:
        found.append(f"{at}: {value} is more than {schema['maximum']}")
    if "minItems" in schema and isinstance(value, list) and len(value) < schema["minItems"]:
        found.append(f"{at}: {len(value)} items are fewer than {schema['minItems']}")
    if "maxItems" in schema and isinstance(value, list) and len(value) > schema["maxItems"]:
        found.append(f"{at}: {len(value)} items are more than {schema['maxItems']}")
    return found
