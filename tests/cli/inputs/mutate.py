"""mutate.py FILE KIND: breaks a FOLD file with a motion in one place and prints it."""
import json
import sys

file, kind = sys.argv[1:]
text = open(file).read()
fold = json.loads(text)
frames = [f for f in fold["file_frames"] if "plico:time" in f]
others = [f for f in fold["file_frames"] if "plico:time" not in f]
middle = frames[len(frames) // 2]
angles = middle["edges_foldAngle"]
bent = max(range(len(angles)), key=lambda e: abs(angles[e]))

if kind == "swap-sign":
    angles[bent] *= -1
elif kind == "add-angle":
    angles[bent] += 2.9  # degrees, 0.05 radians
elif kind == "drop-middle":
    frames = frames[: len(frames) // 10 + 1] + frames[-1:]
elif kind == "move-sheet-vertex":
    fold["vertices_coords"][-1][0] += 0.01
elif kind == "move-frame-vertex":
    middle["vertices_coords"][-1][2] += 0.01
elif kind == "move-folded-vertex":
    others[0]["vertices_coords"][-1][2] += 0.01
elif kind == "reverse":
    times = [f["plico:time"] for f in frames]
    frames.reverse()
    for frame, time in zip(frames, times):
        frame["plico:time"] = time
elif kind == "reorder":
    frames[1], frames[2] = frames[2], frames[1]
elif kind.startswith("drop-key:"):
    del middle[kind.split(":", 1)[1]]
elif kind == "parent-1":
    middle["frame_parent"] = 1
elif kind == "stop-short":
    frames = frames[: len(frames) // 2]
    for frame in frames:
        frame["plico:time"] /= frames[-1]["plico:time"] if frame is not frames[-1] else 1
    frames[-1]["plico:time"] = 1
elif kind == "start-bent":
    frames = frames[len(frames) // 4 :]
    first = frames[0]["plico:time"]
    for frame in frames:
        frame["plico:time"] = (frame["plico:time"] - first) / (1 - first)
elif kind == "call-it-border":
    fold["edges_assignment"][bent] = "B"
elif kind == "call-it-cut":
    fold["edges_assignment"][bent] = "C"
elif kind == "cut-file":
    print(text[: len(text) // 2])
    sys.exit()
else:
    sys.exit(f"no such kind: {kind}")
fold["file_frames"] = others + frames
json.dump(fold, sys.stdout)
