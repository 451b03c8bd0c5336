# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules of the house as functions: each takes the root of a source tree and returns one line per violation.

The map rule: haptics <- devices <- filters <- ui <- plugin. A folder includes only from itself and from its left;
testing includes everything and nothing includes testing.
"""

import re
import subprocess
from collections import Counter, deque
from pathlib import Path

LAYERS = ["haptics", "devices", "filters", "ui", "plugin", "testing"]
PRODUCT = LAYERS[:-1]
# Within filters/ the same rule holds again.
FILTER_MODULES = ["pipeline", "interaction", "views"]
PLAIN_LAYERS = ("haptics", "devices")
VTK_LAYERS = ("filters", "ui", "plugin")

# Limits of a reader's view: sources standing directly in one folder (headers count), lines of one file.
MOST_SOURCES = 25
MOST_LINES = 450
# Everybody reads the header of the session first.
MOST_LINES_OF = {"filters/interaction/session/vtkHapticSession.h": 250}

# Headers of the project behind one header. The list of stages counts as one: it has every stage's plan by value, and with it all
# that a tick knows.
MOST_PULLED = 60
LIST_OF_STAGES = Path("haptics", "tick", "Stages.h")

CODE_SUFFIXES = {".h", ".cpp", ".cxx", ".hpp", ".hxx", ".cc", ".c"}
MARKUP_SUFFIXES = {".xml", ".qrc", ".ui"}
COMMENTED_SUFFIXES = CODE_SUFFIXES | MARKUP_SUFFIXES | {".py", ".cmake", ".sh"}
COMMENTED_NAMES = {"CMakeLists.txt", ".clang-tidy", ".gitignore"}
SKIPPED_FOLDERS = {".git", "cache", "out", "__pycache__"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
CGAL = re.compile(r"^CGAL/")
CHOLMOD = re.compile(r"^(suitesparse/)?cholmod\w*\.h$")
VTK = re.compile(r"^vtk(?!Haptic|Touch|ImageCurves)\w*\.h(xx)?$")
PARAVIEW = re.compile(r"^(vtkPV|vtkSM(?!PTools)|vtkSI|vtkPVRender|pq)\w*\.h$")
QT = re.compile(r"^(Q[A-Z]\w*(/\w+)?|Qt\w*/\w+|q[a-z]\w*\.h|pq(?!Haptic)\w+\.h)$")
HIDAPI = re.compile(r"^(hidapi/)?hidapi\w*\.h$")
DBUS = re.compile(r"^dbus/")

# Forbidden includes of each place: pattern, in words, and why.
FORBIDDEN = {
    "haptics": [(VTK, "VTK"), (QT, "Qt"), (HIDAPI, "hidapi"), (DBUS, "D-Bus")],
    "devices": [(VTK, "VTK"), (QT, "Qt"), (CGAL, "CGAL"), (CHOLMOD, "CHOLMOD")],
    "filters": [(QT, "Qt"), (CGAL, "CGAL"), (CHOLMOD, "CHOLMOD"), (HIDAPI, "hidapi"), (DBUS, "D-Bus")],
    "filters/pipeline": [(PARAVIEW, "ParaView")],
    "filters/interaction": [(PARAVIEW, "ParaView")],
    "ui": [(CGAL, "CGAL"), (CHOLMOD, "CHOLMOD"), (HIDAPI, "hidapi"), (DBUS, "D-Bus")],
    "ui/cli": [(QT, "Qt"), (PARAVIEW, "ParaView")],
    "plugin": [(CGAL, "CGAL"), (CHOLMOD, "CHOLMOD"), (HIDAPI, "hidapi"), (DBUS, "D-Bus")],
}

# Written in pieces, so that this file keeps its own rule.
MACHINE_PATHS = re.compile("(?<![\\w.$}~-])/(" + "|".join(["wor" + "k", "far" + "m", "tm" + "p", "ro" + "ot", "hom" + "e"]) + ")/")
REGISTRY_HOSTS = re.compile("|".join(["deb\\.debian" + "\\.org", "pypi" + "\\.org", "registry\\.npmjs" + "\\.org"]))


def files_of(root):
    """All files of the project under `root`: those that git tracks; without git all but build trees, caches and outputs."""
    listing = subprocess.run(["git", "ls-files", "-z"], cwd=root, capture_output=True, text=True, check=False)
    if (root / ".git").exists() and listing.returncode == 0:
        candidates = [root / name for name in listing.stdout.split("\0") if name]
    else:
        candidates = [path for path in root.rglob("*") if not _is_product(path.relative_to(root).parts)]
    return sorted(path for path in candidates if path.is_file() and not path.is_symlink())


def _is_product(parts):
    return parts[0].startswith("build") or any(part in SKIPPED_FOLDERS for part in parts)


def layer_of(relative):
    return relative.parts[0] if relative.parts[0] in LAYERS else None


def code_files(root):
    """(path, path relative to root, layer) of every C++ file in a layer."""
    for path in files_of(root):
        relative = path.relative_to(root)
        if path.suffix in CODE_SUFFIXES and layer_of(relative):
            yield path, relative, layer_of(relative)


def includes_of(path):
    """(line number, included name) of each include directive."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(2)


def headers_by_name(root):
    """Where a header included by its plain name (the VTK way) stands; generated export headers count as their module's."""
    names = {}
    for _, relative, _ in code_files(root):
        if relative.suffix == ".h":
            names.setdefault(relative.name, []).append(relative)
    for module in FILTER_MODULES:
        name = f"vtkHaptic{module.capitalize()}Module.h"
        names.setdefault(name, []).append(Path("filters", module, name))
    return names


def resolve(including, name, by_name):
    """The project's file that `name` means when `including` includes it, or None for a foreign header."""
    if layer_of(Path(name)) and len(Path(name).parts) > 1:
        return Path(name)
    if name.startswith(".."):
        return Path(*_normalised(including.parent / name))
    candidates = by_name.get(Path(name).name, [])
    own = [candidate for candidate in candidates if candidate.parent == including.parent]
    return (own or candidates or [None])[0]


def _normalised(path):
    parts = []
    for part in path.parts:
        if part == ".." and parts:
            parts.pop()
        elif part != ".":
            parts.append(part)
    return parts


def points_left(source, target):
    """Does the arrow from file `source` to file `target` follow the map rule?"""
    from_layer, to_layer = layer_of(source), layer_of(target)
    if from_layer == "testing":
        return True
    if to_layer == "testing" or LAYERS.index(to_layer) > LAYERS.index(from_layer):
        return False
    if from_layer == to_layer == "filters" and source.parts[1] in FILTER_MODULES and target.parts[1] in FILTER_MODULES:
        return FILTER_MODULES.index(target.parts[1]) <= FILTER_MODULES.index(source.parts[1])
    return True


def map_rule(root):
    """Includes that point to the right."""
    by_name = headers_by_name(root)
    found = []
    for path, relative, _ in code_files(root):
        for number, name in includes_of(path):
            target = resolve(relative, name, by_name)
            if target and layer_of(target) and not points_left(relative, target):
                found.append(f"{relative}:{number}: includes {target}, against haptics <- devices <- filters <- ui <- plugin")
    return found


def product_files(root):
    """(path, path relative to root) of every C++ file that is not a test."""
    return [(path, relative) for path, relative, layer in code_files(root) if layer in PRODUCT]


def full_rooms(root):
    """Folders of the product with more sources directly in them than a reader takes in at once."""
    counts = Counter(relative.parent for _, relative in product_files(root))
    return [
        f"{room}: {count} sources, at most {MOST_SOURCES}: divide it into rooms"
        for room, count in sorted(counts.items())
        if count > MOST_SOURCES
    ]


def long_files(root):
    """Files of the product that hold more than one idea by their length alone."""
    lengths = [(relative, len(path.read_text(encoding="utf-8").splitlines())) for path, relative in product_files(root)]
    limits = [(relative, lines, MOST_LINES_OF.get(str(relative), MOST_LINES)) for relative, lines in lengths]
    return [f"{relative}: {lines} lines, at most {most}" for relative, lines, most in limits if lines > most]


def include_arrows(root):
    """For each file of the product the files of the product that it includes."""
    by_name = headers_by_name(root)
    known = {relative for _, relative in product_files(root)}
    return {
        relative: {resolve(relative, name, by_name) for _, name in includes_of(path)} & known
        for path, relative in product_files(root)
    }


def pulled(header, arrows):
    """The headers of the project that one header brings along."""
    found, ways = set(), [header]
    while ways:
        new = {target for target in arrows.get(ways.pop(), ()) if target.suffix == ".h"} - found
        found |= new
        ways.extend(new)
    return found


def heavy_headers(root):
    """Headers that bring along more of the project than a compiler should read for one name."""
    arrows = include_arrows(root)
    of_stages = pulled(LIST_OF_STAGES, arrows)
    counts = [(header, len(pulled(header, arrows) - of_stages)) for header in sorted(arrows) if header.suffix == ".h"]
    return [
        f"{header}: brings along {count} headers, at most {MOST_PULLED}: declare names instead"
        for header, count in counts
        if count > MOST_PULLED
    ]


def room_arrows(arrows):
    """The arrows between files as arrows between the folders they stand in."""
    rooms = {}
    for source, targets in arrows.items():
        others = {target.parent for target in targets} - {source.parent}
        rooms.setdefault(source.parent, set()).update(others)
    return rooms


def circle_through(start, arrows):
    """The shortest path along the arrows from `start` back to it, both ends named, or None."""
    came_from, ways = {}, deque([start])
    while ways:
        node = ways.popleft()
        for target in sorted(arrows.get(node, ())):
            if target == start:
                way = [start, node]
                while way[-1] != start:
                    way.append(came_from[way[-1]])
                return way[::-1]
            if target not in came_from:
                came_from[target] = node
                ways.append(target)
    return None


def include_circles(root):
    """Files that include one another in a circle, and folders that do."""
    files = include_arrows(root)
    found = []
    for arrows in (files, room_arrows(files)):
        told = set()
        for node in sorted(arrows):
            way = None if node in told else circle_through(node, arrows)
            if way:
                told.update(way)
                found.append(f"{node}: includes go in a circle: {' -> '.join(map(str, way))}")
    return found


def forbidden_libraries(root):
    """Libraries in layers that must not know them, and CGAL and CHOLMOD in any header."""
    found = []
    for path, relative, layer in code_files(root):
        if layer == "testing":
            continue
        places = [layer, "/".join(relative.parts[:2])]
        rules = [rule for place in places for rule in FORBIDDEN.get(place, [])]
        if relative.suffix == ".h":
            rules = rules + [(CGAL, "CGAL (never in a header)"), (CHOLMOD, "CHOLMOD (never in a header)")]
        for number, name in includes_of(path):
            found += [f"{relative}:{number}: {name}: no {words} here" for pattern, words in rules if pattern.match(name)]
    return found


def extensions(root):
    """The extension tells the layer: .h/.cpp plain C++, .h/.cxx VTK and Qt style."""
    found = []
    for _, relative, layer in code_files(root):
        allowed = {".h", ".cpp"} if layer in PLAIN_LAYERS else {".h", ".cxx"}
        if layer == "testing":
            allowed = {".h", ".cpp", ".cxx"}
        if relative.suffix not in allowed:
            found.append(f"{relative}: extension {relative.suffix}, allowed in {layer}/: {', '.join(sorted(allowed))}")
    return found


def _is_script(path):
    with open(path, "rb") as file:
        return file.read(2) == b"#!"


def spdx_line(root):
    """Every source file names its licence in the first line (after #!, <?xml and, where a reader wants it first, the root)."""
    found = []
    for path in files_of(root):
        commented = path.suffix in COMMENTED_SUFFIXES or path.name in COMMENTED_NAMES
        if not commented and (path.suffix or not _is_script(path)):
            continue
        lines = path.read_text(encoding="utf-8").splitlines()[:3]
        if path.suffix not in MARKUP_SUFFIXES:
            lines = lines[:2] if lines and lines[0].startswith("#!") else lines[:1]
        if not any("SPDX-License-Identifier: GPL-3.0-or-later" in line for line in lines):
            found.append(f"{path.relative_to(root)}:1: no SPDX-License-Identifier: GPL-3.0-or-later")
    return found


def text_of_the_project(root):
    """No text names a folder of somebody's machine or the host of a package registry."""
    found = []
    for path in files_of(root):
        try:
            lines = path.read_text(encoding="utf-8").splitlines()
        except UnicodeDecodeError:
            continue  # a picture or a recording
        for number, line in enumerate(lines, start=1):
            for pattern in (MACHINE_PATHS, REGISTRY_HOSTS):
                match = pattern.search(line)
                if match:
                    found.append(f"{path.relative_to(root)}:{number}: '{match.group(0)}'")
    return found


ALL = [map_rule, full_rooms, long_files, heavy_headers, include_circles, forbidden_libraries, extensions, spdx_line, text_of_the_project]
