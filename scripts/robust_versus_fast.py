#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `triplex audit` on fields against both fast roads and prints Markdown tables.

usage: scripts/robust_versus_fast.py TRIPLEX FIELD[:TENSOR]... [--tolerance EPS] [--threads N] [--max-bisections N]
       [--roads a-patches,vtk-contour]

One row per field, road and feature: components and open tets of both sides, the tets where the topology differs, by kind
and by who is right, cracks of the fast mesh and the distance from the robust mesh to it; and a table of times.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROADS = ("a-patches", "vtk-contour")


def audit(options, field, tensor, road, folder):
    command = [options.triplex, "audit", field, "-o", folder, "--against", road, "--quiet",
               "--tolerance", str(options.tolerance), "--threads", str(options.threads)]
    if options.max_bisections is not None:
        command += ["--max-bisections", str(options.max_bisections)]
    if tensor:
        command += ["--tensor", tensor]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 2, 3):
        sys.exit(f"{field}: {done.stderr.strip()}")
    return json.loads((pathlib.Path(folder) / "audit.json").read_text())


def distance(d):
    if d is None:
        return "-"
    return "inf" if d["upper"] == "infinity" else f"{d['upper']:.2g}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("triplex")
    parser.add_argument("fields", nargs="+")
    parser.add_argument("--tolerance", type=float, default=1e-3)
    parser.add_argument("--threads", type=int, default=0)
    parser.add_argument("--max-bisections", type=int)
    parser.add_argument("--roads", default=",".join(ROADS))
    options = parser.parse_args()
    times = []
    print("| field | tets | fast road | feature | components, robust / fast | missed / invented | euler | open tets | missed | invented | label "
          "| pieces, shape | right: robust / fast / undecided | cracks of fast | distance |")
    print("|---|---:|---|---|---|---|---|---|---:|---:|---:|---:|---|---:|---:|")
    for field in options.fields:
        field, _, tensor = field.partition(":")
        for road in options.roads.split(","):
            with tempfile.TemporaryDirectory() as folder:
                result = audit(options, field, tensor, road, folder)
            name = pathlib.Path(field).stem
            cost = result["cost"]
            times.append((name, result["field"]["tets"], road, cost, result["certificate_refuted"]))
            for feature, f in result["features"].items():
                robust, other, cells, right = f["robust"], f["other"], f["differing_tets"], f["right"]
                if robust["components"] == 0 and other["components"] == 0:
                    continue
                defects = other.get("defects", {})
                cracks = defects.get("open-edge", 0) + defects.get("crack", 0)
                print(f"| {name} | {result['field']['tets']} | {road} | {feature} "
                      f"| {robust['components']} / {other['components']} "
                      f"| {len(f.get('components_missed', []))} / {len(f.get('components_invented', []))} | {robust['euler']} / {other['euler']} "
                      f"| {robust['open_tets']} / {other['open_tets']} | {cells['missed']} | {cells['invented']} "
                      f"| {cells['label']} | {cells['components'] + cells['shape']} "
                      f"| {right['robust']} / {right['other']} / {right['undecided']} | {cracks} "
                      f"| {distance(f['distance_robust_to_other'])} |", flush=True)
    print("\n| field | tets | fast road | robust, s | fast, s | robust : fast | robust, MiB | fast, MiB | a certificate refuted |")
    print("|---|---:|---|---:|---:|---:|---:|---:|---|")
    for name, tets, road, cost, refuted in times:
        robust, other = cost["robust"], cost["other"]
        mib = lambda c: "-" if c["bytes"] is None else f"{c['bytes'] / 2**20:.0f}"
        print(f"| {name} | {tets} | {road} | {robust['seconds']:.2f} | {other['seconds']:.2f} "
              f"| {robust['seconds'] / max(other['seconds'], 1e-9):.1f} | {mib(robust)} | {mib(other)} "
              f"| {'YES' if refuted else 'no'} |")


if __name__ == "__main__":
    main()
