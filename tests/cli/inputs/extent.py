# Extent in millimetres of what a drawing shows, measured on what programs of others made of it:
#   extent.py FILE.dxf LAYER      by ezdxf
#   extent.py FILE.svg '#rrggbb'  lines of a colour in an SVG by poppler's pdftocairo, whose unit is a point
import math
import re
import sys
import xml.etree.ElementTree as tree


def of_dxf(path, layer):
    import ezdxf
    from ezdxf import bbox

    drawing = ezdxf.readfile(path)
    assert drawing.header["$INSUNITS"] == 4, "not millimetres"
    box = bbox.extents(drawing.modelspace().query(f'*[layer=="{layer}"]'))
    return box.size.x, box.size.y


def color_of(node):
    stroke = re.search(r"stroke:([^;]*)", node.get("style", "")) or re.match("(.*)", node.get("stroke", ""))
    channels = re.findall(r"[\d.]+", stroke.group(1).partition("(")[2])
    if not channels:
        return stroke.group(1).lower()
    scale = 2.55 if "%" in stroke.group(1) else 1
    return "#" + "".join(f"{round(float(x) * scale):02x}" for x in channels[:3])


def of_svg(path, color):
    points = []
    for node in tree.parse(path).iter("{http://www.w3.org/2000/svg}path"):
        if color_of(node) != color:
            continue
        numbers = [float(x) for x in re.findall(r"-?[\d.]+(?:e-?\d+)?", node.get("d"))]
        matrix = [float(x) for x in re.findall(r"-?[\d.]+(?:e-?\d+)?", node.get("transform", "1 0 0 1 0 0"))]
        a, b, c, d, e, f = matrix
        for x, y in zip(numbers[::2], numbers[1::2]):
            points.append((a * x + c * y + e, b * x + d * y + f))
    size = [(max(p[i] for p in points) - min(p[i] for p in points)) * 25.4 / 72 for i in (0, 1)]
    return size


size = (of_dxf if sys.argv[1].endswith(".dxf") else of_svg)(*sys.argv[1:])
print("{:.2f} x {:.2f} mm".format(*(s + 0.0 for s in size)))
assert all(math.isfinite(s) for s in size)
