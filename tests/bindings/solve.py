"""The library from Python: run by tests/bindings/bindings.sh with the folder of the source tree."""

import json
import os
import pathlib
import signal
import sys
import tempfile
import threading
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(sys.argv.pop())
sys.path.insert(0, str(ROOT / "bindings"))
sys.dont_write_bytecode = True
import crumple  # noqa: E402

DEMO = ROOT / "share/scenes/q7-fiat500.json"


def wall(speed_kmh):
    scene = json.loads((ROOT / "share/scenes/wall-56.json").read_text())
    scene["settings"] = {"voxel_mm": 100, "dt_ms": 2}
    for part in scene["participants"]:
        if part["kind"] == "vehicle":
            part["speed_kmh"] = speed_kmh
    return scene


class Solve(unittest.TestCase):
    def test_the_numbers_of_the_program(self):
        with os.popen(f"'{os.environ['CRUMPLE']}' run '{DEMO}'") as run:
            want = json.load(run)
        result = crumple.solve(DEMO)
        self.assertEqual(result.dict(resolved=True), want)
        self.assertEqual(result["A.ees_kmh"], want["participants"][0]["ees_kmh"])
        self.assertEqual(result["B.cdc"], want["participants"][1]["cdc"])
        self.assertEqual(repr(result).count("EES"), 2)  # not once more for each impact

    def test_text_bytes_and_dict_are_scenes(self):
        scene = wall(50)
        values = {
            crumple.solve(s)["A.ees"] for s in (scene, json.dumps(scene), json.dumps(scene).encode())
        }
        self.assertEqual(len(values), 1)

    def test_set(self):
        result = crumple.solve(wall(50), set={"A.speed_kmh": 30, "restitution": 0})
        self.assertAlmostEqual(result["A.delta_v"], 30, delta=0.5)

    def test_an_error_has_place_and_hint(self):
        scene = wall(50)
        scene["participants"][0]["masskg"] = 1
        with self.assertRaises(crumple.Error) as caught:
            crumple.solve(scene)
        self.assertEqual(caught.exception.code, "unknown-key")
        self.assertEqual(caught.exception.where, "/participants/0/masskg")
        self.assertEqual(caught.exception.line, 1)
        self.assertIn("mass_kg", str(caught.exception))
        with self.assertRaises(FileNotFoundError):
            crumple.solve("/nowhere.json")
        with self.assertRaises(ValueError):
            crumple.solve({"crumple": float("nan")})
        with self.assertRaises(crumple.Error):
            crumple.Crumple("/nowhere")

    def test_names(self):
        result = crumple.solve(wall(50))
        self.assertTrue(all(result[name] is not None for name in result.names()))
        self.assertIsNone(result.get("A.colour"))
        with self.assertRaises(KeyError):
            result["A.colour"]

    def test_series_and_field(self):
        result = crumple.solve(wall(50))
        t, v = result.series("t_s"), result.series("A.vx_mps")
        self.assertEqual(len(t), len(v))
        self.assertAlmostEqual(v[0], 50 / 3.6, delta=1)
        trace = result.dict(trace=True)["trace"]
        self.assertAlmostEqual(v[5], trace["A"]["vx_mps"][5], delta=1e-9)
        damage = result.field("A")
        self.assertGreater(sum(map(sum, damage)), 1)
        self.assertAlmostEqual(len(damage[0]) * result.frame("A")["edge_m"], 4.4, delta=0.8)
        with self.assertRaises(KeyError):
            result.series("A.colour")
        with self.assertRaises(KeyError):
            result.field("A", "colour")

    def test_damage(self):
        measured = {
            "crumple_damage": 1,
            "vehicles": [
                {
                    "id": "A",
                    "type": "sedan",
                    "mass_kg": 1600,
                    "damage": {
                        "face": "front",
                        "field_length_m": 1.4,
                        "crush_m": [0.12, 0.14, 0.20, 0.22, 0.18, 0.10],
                    },
                }
            ],
            "object": {},
        }
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            json.dump(measured, file)
            file.flush()
            with os.popen(f"'{os.environ['CRUMPLE']}' damage -f json '{file.name}'") as run:
                self.assertEqual(crumple.damage(measured), json.load(run))
        del measured["vehicles"][0]["mass_kg"]
        measured["vehicles"][0]["damage"]["crush_m"] = "deep"
        with self.assertRaises(crumple.Error) as caught:
            crumple.damage(measured)
        self.assertTrue(caught.exception.where)

    def test_import(self):
        data = ROOT / "tests/data/import"
        want = json.loads((data / "long.jsonl").read_text())
        self.assertEqual(crumple.import_file(data / "long.csv"), ([want], []))
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            file.write("case,time [s],id,x [m],y [m],heading [deg],speed [km/h]\n")
            for i, speed in (1, 50), (2, 40), (3, ""):
                file.write(f"{i},0,A,0,0,0,{speed}\n{i},0,B,20,0,180,50\n")
            file.flush()
            scenes, errors = crumple.import_file(file.name)
            self.assertEqual([s["source"]["case"] for s in scenes], ["1", "2"])
            self.assertEqual([e.code for e in errors], ["missing"])
            self.assertEqual(crumple.import_file(file.name, case="2"), (scenes[1:], []))
        with self.assertRaises(crumple.Error) as caught:
            crumple.import_file(data / "long.csv", reference="roof")
        self.assertEqual(caught.exception.code, "usage")

    def test_picture(self):
        result = crumple.solve(wall(50))
        svg = xml.etree.ElementTree.fromstring(result.svg())
        self.assertTrue(svg.tag.endswith("svg"))
        self.assertNotEqual(result.svg(0.05), result.svg())
        self.assertIn("<svg", result._repr_html_())

    def test_interrupt(self):
        slow = wall(50)
        slow["settings"] = {"voxel_mm": 10, "dt_ms": 0.05}
        timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            for _ in range(100):
                crumple.solve(slow)
        timer.join()
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)
        timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            crumple.solve_many((slow for _ in range(200)), jobs=1)
        timer.join()


class Many(unittest.TestCase):
    def test_columns_in_order_with_errors(self):
        scenes = [wall(v) for v in range(20, 60, 4)] + [{}]
        table = crumple.solve_many(scenes, jobs=3, values=["A.ees", "A.cdc"])
        self.assertEqual(list(table), ["A.ees", "A.cdc", "error"])
        self.assertEqual(table["A.ees"][:-1], sorted(table["A.ees"][:-1]))
        self.assertEqual(table["error"][:-1], [None] * 10)
        self.assertIn("crumple", table["error"][-1])
        self.assertIsNone(table["A.ees"][-1])
        self.assertIn("<td>", table._repr_html_())
        self.assertEqual(table["A.ees"][3], crumple.solve(scenes[3])["A.ees"])

    def test_models_beside_the_files_of_the_scenes(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = []
            for i, kind in enumerate(("compact/12", "suv/12")):
                scene = wall(50)
                scene["participants"][0]["model"] = {"file": "own.json"}
                paths.append(pathlib.Path(folder, str(i), "scene.json"))
                paths[i].parent.mkdir()
                paths[i].write_text(json.dumps(scene))
                own = paths[i].parent / "own.json"
                os.system(f"'{os.environ['CRUMPLE']}' models {kind} --flat --to '{own}'")
            bad = pathlib.Path(folder, "bad.json")
            bad.write_text("{\n}")
            want = [crumple.solve(path)["A.ees"] for path in paths]
            table = crumple.solve_many(paths + [wall(50), bad], jobs=2, values=["A.ees"])
            self.assertNotEqual(want[0], want[1])
            self.assertEqual(table["A.ees"][:2], want)
            self.assertIsNone(table["error"][2])  # and what has no file starts from here again
            self.assertTrue(table["error"][3].startswith(f"{bad}:1:1: "), table["error"][3])

    def test_an_exception_of_the_scenes_arrives(self):
        with self.assertRaises(ZeroDivisionError):
            crumple.solve_many(1 / 0 for _ in range(3))

    def test_pandas(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("no pandas")
        frame = crumple.solve_many([wall(30), wall(40)], values=["A.ees"]).frame()
        self.assertEqual(frame.shape, (2, 2))

    def test_threads_of_python(self):
        got = []
        threads = [
            threading.Thread(target=lambda: got.append(crumple.solve(wall(45))["A.ees"]))
            for _ in range(4)
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(set(got)), 1)
        self.assertEqual(len(got), 4)


unittest.main()
