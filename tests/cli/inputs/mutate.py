"""mutate.py FILE KIND...: breaks a FOLD file in one place for each KIND and lets `plico verify` judge it.

One line a kind: KIND: what was said first. A file that passes, or crashes verify, is told on standard output. A kind may
name a piece of a kit, as piece 1 in reverse@1: then it is about the motion of that piece.
"""
import copy
import json
import re
import subprocess
import sys


def middle(frames):
    return frames[len(frames) // 2]


def most_bent(frame):
    angles = frame["edges_foldAngle"]
    return max(range(len(angles)), key=lambda e: abs(angles[e]))


# ---- The motion: each takes the file and the frames of its motion, and gives those that take their place.

def swap_sign(fold, frames):
    middle(frames)["edges_foldAngle"][most_bent(middle(frames))] *= -1


def add_angle(fold, frames):
    middle(frames)["edges_foldAngle"][most_bent(middle(frames))] += 2.9  # degrees, 0.05 radians


def drop_middle(fold, frames):
    return frames[: len(frames) // 10 + 1] + frames[-1:]


def move_frame_vertex(fold, frames):
    middle(frames)["vertices_coords"][-1][2] += 0.01


def reverse(fold, frames):
    times = [frame["plico:time"] for frame in frames]
    frames.reverse()
    for frame, time in zip(frames, times):
        frame["plico:time"] = time


def reorder(fold, frames):
    frames[1], frames[2] = frames[2], frames[1]


def parent_1(fold, frames):
    middle(frames)["frame_parent"] += 1


def stop_short(fold, frames):
    if len(frames) == 2:  # straight: half of the angles
        frames[1]["edges_foldAngle"] = [angle / 2 for angle in frames[1]["edges_foldAngle"]]
        return frames
    frames = frames[: len(frames) // 2]
    last = frames[-1]["plico:time"]
    for frame in frames:
        frame["plico:time"] /= last
    return frames


def start_bent(fold, frames):
    frames = frames[len(frames) // 4 :]
    first = frames[0]["plico:time"]
    for frame in frames:
        frame["plico:time"] = (frame["plico:time"] - first) / (1 - first)
    return frames


def drop_motion(fold, frames):
    return []


MOTION = {f.__name__.replace("_", "-"): f for f in (
    swap_sign, add_angle, drop_middle, move_frame_vertex, reverse, reorder, parent_1, stop_short, start_bent,
    drop_motion)}


# ---- The sheet and its folded form.

def move_sheet_vertex(fold):
    fold["vertices_coords"][-1][0] += 0.01
    for frame in fold["file_frames"]:  # of a kit: in both places
        if frame.get("plico:piece") == max(fold.get("faces_plico:part", [0])):
            frame["vertices_coords"][-1][0] += 0.01


def move_folded_vertex(fold):
    fold["file_frames"][0]["vertices_coords"][-1][2] += 0.01


def call_it(letter):
    def change(fold):
        fold["edges_assignment"][most_bent(fold)] = letter
    return change


# ---- Kits: pieces, joints, order.

def pieces(fold):
    return [frame for frame in fold["file_frames"] if "plico:piece" in frame]


def seam_edges(fold):
    return [e for e, number in enumerate(fold["edges_plico:seam"]) if number]


def swap_mates(fold):
    """Two seams of equal length exchange one of their sides."""
    mate = fold["edges_plico:mate"]
    a, b = seam_edges(fold)[:2]
    c, d = mate[a], mate[b]
    mate[a], mate[b], mate[c], mate[d] = d, c, b, a


def drop_seams(fold):
    for e in seam_edges(fold):
        fold["edges_plico:seam"][e] = fold["edges_plico:mate"][e] = None


def swap_numbers(fold):
    seam = fold["edges_plico:seam"]
    a, b = seam_edges(fold)[:2]
    seam[a], seam[b] = seam[b], seam[a]


def move_joint(fold):
    for corner in fold["plico:joints"][0]["polygon"]:
        corner[0] += 3


def lift_joint(fold):
    for corner in fold["plico:joints"][0]["polygon"]:
        corner[2] += 0.01


def turn_joint(fold):
    fold["plico:joints"][0]["polygon"].reverse()


def grow_joint(fold):
    a, b, c = fold["plico:joints"][0]["polygon"][:3]
    for i in range(3):
        a[i] += (b[i] - c[i]) / 100


def dent_joint(fold):
    polygon = fold["plico:joints"][0]["polygon"]
    mean = [sum(corner[i] for corner in polygon) / len(polygon) for i in range(3)]
    polygon.insert(1, mean)


def set_joint(key, value):
    def change(fold):
        fold["plico:joints"][0][key] = value
    return change


def repeat_joint(fold):
    fold["plico:joints"].append(copy.deepcopy(fold["plico:joints"][0]))


def set_step(step):
    def change(fold):
        fold["plico:parts"][-1]["step"] = step
    return change


def same_name(fold):
    fold["plico:parts"][-1]["name"] = fold["plico:parts"][0]["name"]


def wrong_title(fold):
    pieces(fold)[0]["frame_title"] = pieces(fold)[-1]["frame_title"]


def exchange_face(fold):
    first, last = fold["plico:parts"][0]["faces"], fold["plico:parts"][-1]["faces"]
    first[0], last[0] = last[0], first[0]


def claim_piece(fold):
    fold["plico:parts"][-1]["pieces"] = [0]


def move_piece_vertex(fold):
    pieces(fold)[-1]["vertices_coords"][0][0] += 0.01


def bend_piece(fold):
    piece = pieces(fold)[-1]
    piece["edges_foldAngle"][most_bent(piece)] += 1


def drop_piece(fold):
    fold["file_frames"].remove(pieces(fold)[-1])


def number_piece(fold):
    pieces(fold)[-1]["plico:piece"] += 1


def drop_key_of_piece(fold):
    del pieces(fold)[-1]["plico:piece"]


SHEET = {
    "call-it-border": call_it("B"), "call-it-cut": call_it("C"), "step-twice": set_step(1), "step-beyond": set_step(99),
    "joint-other-face": set_joint("faces", [0, 1]), "joint-no-face": set_joint("faces", [0, 999]),
    "joint-other-part": set_joint("parts", [1, 0]), "joint-no-part": set_joint("parts", [0, 9]),
    "joint-empty": set_joint("polygon", []), "joint-text": set_joint("polygon", [["a", 0, 0]]),
}
SHEET |= {f.__name__.replace("_", "-"): f for f in (
    move_sheet_vertex, move_folded_vertex, swap_mates, drop_seams, swap_numbers, move_joint, lift_joint, turn_joint,
    grow_joint, dent_joint, repeat_joint, same_name, wrong_title, exchange_face, claim_piece, move_piece_vertex,
    bend_piece, drop_piece, number_piece, drop_key_of_piece)}


def span_of_motion(fold, piece):
    """Where the motion of a piece, or of the whole when it is None, begins and ends in file_frames."""
    frames = fold["file_frames"]
    first = 0
    if piece is not None:
        first = 1 + next(i for i, frame in enumerate(frames) if frame.get("plico:piece") == piece)
    while first < len(frames) and "plico:time" not in frames[first]:
        first += 1
    last = first
    while last < len(frames) and "plico:time" in frames[last]:
        last += 1
    return first, last


def mutate(text, kind):
    if kind == "cut-file":
        return text[: len(text) // 2]
    fold = json.loads(text)
    kind, _, piece = kind.partition("@")
    if kind in SHEET:
        SHEET[kind](fold)
        return json.dumps(fold)
    first, last = span_of_motion(fold, int(piece) if piece else None)
    frames = fold["file_frames"][first:last]
    if kind.startswith("drop-key:"):
        del middle(frames)[kind.split(":", 1)[1]]
    else:
        changed = MOTION[kind](fold, frames)
        frames = frames if changed is None else changed
    fold["file_frames"][first:last] = frames
    parent = 0  # frames behind those that went have other numbers
    for i, frame in enumerate(fold["file_frames"]):
        if "plico:piece" in frame:
            parent = i + 1
        elif piece and len(frames) != last - first and i >= first + len(frames) and "plico:time" in frame:
            frame["frame_parent"] = parent
    return json.dumps(fold)


def what_is_said(text):
    for pattern in (r"^  [a-z]+/.*", r"^proof +(?:panels|add|does).*", r"^  .*collide.*", r"plico: .*"):
        found = re.search(pattern, text, re.M)
        if found:
            return found.group().strip()
    return ""


def main():
    text = open(sys.argv[1]).read()
    for kind in sys.argv[2:]:
        broken = mutate(text, kind)
        judged = subprocess.run(["plico", "verify", "-"], input=broken, capture_output=True, text=True, check=False)
        if judged.returncode not in (1, 3):
            print(f"{kind} passes: {judged.returncode}")
        print(f"{kind}: {what_is_said(judged.stdout + judged.stderr)}", file=sys.stderr)


main()
