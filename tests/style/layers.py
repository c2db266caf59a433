"""Modules are layers: a file includes only headers of its own module and of what weavefront_module(... USES
...) declares for it, directly or through the modules that it uses. The build's include folders enforce the
same for our own headers; this check says which line is wrong, and covers the libraries that stand in the
compiler's default folders."""

import re
import sys

from sources import CPP, ROOT, report

PROGRAM = "app"  # src/app, above all modules
LIBRARIES = {  # header, or folder of headers: target
    "mpi.h": "MPI::MPI_CXX",
    "hdf5.h": "HDF5::HDF5",
    "metis.h": "metis",
    "udunits2.h": "udunits2",
    "CLI": "CLI11::CLI11",
    "Eigen": "Eigen3::Eigen",
    "boost": "Boost::headers",
    "fmt": "fmt::fmt",
    "nlohmann": "nlohmann_json::nlohmann_json",
    "openssl": "OpenSSL::Crypto",
    "spdlog": "spdlog::spdlog",
    "yaml-cpp": "yaml-cpp",
}


def declared_modules():
    """Name of each module: (its folders, the targets that it uses)."""
    modules = {}
    text = re.sub(r"#.*", "", (ROOT / "CMakeLists.txt").read_text())
    for call in re.findall(r"weavefront_module\(([^)]*)\)", text):
        head, _, uses = call.partition("USES")
        words = head.split()
        name = words[0]
        folders = (
            [words[words.index("DIRECTORY") + 1]]
            if "DIRECTORY" in words
            else [f"include/weavefront/{name}", f"src/{name}"]
        )
        modules[name] = (folders, uses.split())
    linked = re.search(
        r"target_link_libraries\(weavefront PRIVATE([^)]*)\)", (ROOT / "src/app/CMakeLists.txt").read_text()
    )
    modules[PROGRAM] = (["src/app"], linked.group(1).split())
    return modules


def allowed_targets(name, modules, path=()):
    """All targets that the module may include, itself among them."""
    if name in path:
        sys.exit(f"CMakeLists.txt: modules in a circle: {' -> '.join((*path, name))}")
    allowed = {f"weavefront::{name}"}
    for target in modules[name][1]:
        module = target.removeprefix("weavefront::")
        allowed |= allowed_targets(module, modules, (*path, name)) if module in modules else {target}
    return allowed


def target_of(header):
    """Target that the header belongs to; None: the standard library or the system."""
    parts = header.split("/")
    return (
        f"weavefront::{parts[1]}" if parts[0] == "weavefront" and len(parts) > 2 else LIBRARIES.get(parts[0])
    )


def defects_of(path, allowed):
    """Messages on the includes of a file that its module may not have."""
    defects = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        found = re.match(r'\s*#\s*include\s*["<]([^">]+)[">]', line)
        if not found:
            continue
        header, place = found.group(1), f"{path.relative_to(ROOT)}:{number}"
        target = target_of(header)
        if ".." in header.split("/"):
            defects.append(f"{place}: {header} reaches out of its folder; include it as weavefront/...")
        elif target and target not in allowed:
            defects.append(f"{place}: includes {header}, but its module does not use {target}")
    return defects


def main():
    modules = declared_modules()
    defects, checked = [], 0
    for name, (folders, _) in modules.items():
        allowed = allowed_targets(name, modules)
        for path in sorted(p for folder in folders for p in (ROOT / folder).rglob("*") if p.suffix in CPP):
            defects += defects_of(path, allowed)
            checked += 1
    return report(defects, checked)


sys.exit(main())
