"""Says which instances a draft 4 schema accepts, with Debian's python3-jsonschema.

Usage: validate.py SCHEMA.json < INSTANCES > VERDICTS
An instance a line, as JSON without comments; a verdict a line: "accepted", or "refused" and why. Fails if SCHEMA.json is
not itself valid.
"""
import json
import sys

from jsonschema import Draft4Validator

with open(sys.argv[1], encoding="utf-8") as file:
    schema = json.load(file)
Draft4Validator.check_schema(schema)
validator = Draft4Validator(schema)
for line in sys.stdin:
    fault = next(validator.iter_errors(json.loads(line)), None)
    if fault is None:
        print("accepted")
    else:
        place = "/".join(str(step) for step in fault.absolute_path)
        print(f"refused {place}: {fault.message.splitlines()[0][:120]}")
