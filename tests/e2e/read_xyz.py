# Reads a trajectory in the extended XYZ format and prints it as JSON: by the format's specification
# (https://github.com/libAtoms/extxyz), or with the argument `ase` by the library ASE.
import json
import re
import sys

KEY = re.compile(r'\s*([A-Za-z_][A-Za-z0-9_-]*)\s*=\s*(?:"([^"]*)"|(\S+))')
TYPES = {"S": str, "I": int, "R": float, "L": lambda word: {"T": True, "F": False}[word]}


def attributes(line):
    found, at = {}, 0
    while at < len(line.rstrip()):
        match = KEY.match(line, at)
        if not match:
            raise ValueError("no key and value: " + line[at:])
        found[match[1]] = match[2] if match[2] is not None else match[3]
        at = match.end()
    return found


def frames(file):
    while True:
        first = file.readline()
        if not first:
            return
        info = attributes(file.readline())
        fields = info["Properties"].split(":")
        columns = [(fields[i], TYPES[fields[i + 1]], int(fields[i + 2])) for i in range(0, len(fields), 3)]
        values = {name: [] for name, _, _ in columns}
        for _ in range(int(first)):
            words = file.readline().split()
            if len(words) != sum(width for _, _, width in columns):
                raise ValueError("%d columns" % len(words))
            for name, read, width in columns:
                its = [read(word) for word in words[:width]]
                words = words[width:]
                values[name].append(its[0] if width == 1 else its)
        yield {"time": float(info["Time"]), "lattice": [float(x) for x in info["Lattice"].split()],
               "pbc": [TYPES["L"](word) for word in info["pbc"].split()], "names": info["species_names"], **values}


def frames_of_ase(path):
    from ase.io import iread
    for atoms in iread(path, format="extxyz", index=":"):
        array = atoms.arrays
        yield {"time": float(atoms.info["Time"]), "lattice": [float(x) for row in atoms.cell.tolist() for x in row],
               "pbc": [bool(x) for x in atoms.pbc], "names": atoms.info["species_names"],
               "species": atoms.get_chemical_symbols(), "pos": atoms.positions.tolist(), "velo": array["velo"].tolist(),
               "radius": array["radius"].tolist(), "mass": array["mass"].tolist(), "id": array["id"].tolist()}


with open(sys.argv[1], encoding="utf-8") as file:
    print(json.dumps(list(frames_of_ase(sys.argv[1]) if sys.argv[2:] == ["ase"] else frames(file))))
