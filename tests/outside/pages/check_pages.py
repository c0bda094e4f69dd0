"""check_pages.py PLICO NET.fold: prints a net as SVG, PDF and DXF and reads the files back with programs and libraries
that are not ours (an XML parser, xmllint, qpdf, Poppler, ezdxf). Claims: the unit is declared, a length of 100 mm
measures 100.00 +- 0.01 mm, the layers are there, every part is one closed outline at the same place in all three,
and the same command gives the same bytes for any number of threads."""
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

import ezdxf

LAYERS = ["CUT", "MOUNTAIN", "VALLEY", "MARK", "TEXT"]
SVG = "{http://www.w3.org/2000/svg}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"


def run(*command):
    return subprocess.run(command, check=True, capture_output=True).stdout


def require(claim, what):
    if not claim:
        sys.exit("check_pages: " + what)


def path_points(path):
    numbers = [float(n) for n in re.findall(r"-?[\d.]+", path)]
    return list(zip(numbers[::2], numbers[1::2]))


class Svg:
    def __init__(self, name):
        run("xmllint", "--noout", name)
        root = xml.parse(name).getroot()
        box = [float(n) for n in root.get("viewBox").split()]
        require(root.get("width").endswith("mm") and root.get("height").endswith("mm"), "the SVG declares no mm")
        self.size = float(root.get("width")[:-2]), float(root.get("height")[:-2])
        require(box == [0, 0, *self.size], "an SVG unit is not a millimetre")
        self.layers = {g.get("id"): g for g in root.iter(SVG + "g") if g.get(INKSCAPE + "groupmode") == "layer"}
        self.texts = [t.text for t in self.layers["TEXT"].iter(SVG + "text")]

    def lines(self, layer):
        for path in self.layers[layer].iter(SVG + "path"):
            points = [(x, self.size[1] - y) for x, y in path_points(path.get("d"))]
            yield points, path.get("d").endswith("Z")


class Pdf:
    def __init__(self, name):
        run("qpdf", "--check", name)
        size = re.search(rb"Page size: +([\d.]+) x ([\d.]+) pts", run("pdfinfo", name))
        self.size = tuple(float(n) * 25.4 / 72 for n in size.groups())
        self.text = run("pdftotext", "-layout", name, "-").decode()
        plain = run("qpdf", "--qdf", "--object-streams=disable", name, "-").decode("latin-1")
        require("/PrintScaling /None" in plain, "the PDF lets viewers scale")
        self.names, self.streams = {}, {}
        for number, body in re.findall(r"^(\d+) 0 obj\n(.*?)\nendobj", plain, re.M | re.S):
            group = re.search(r"/Name \((\w+)\)", body)
            if "/Type /OCG" in body:
                self.names[number] = group.group(1)
        for number, body in re.findall(r"^(\d+) 0 obj\n(.*?)\nendobj", plain, re.M | re.S):
            member = re.search(r"/OC (\d+) 0 R", body)
            if member and "stream\n" in body:
                self.streams[self.names[member.group(1)]] = body.split("stream\n", 1)[1]

    def lines(self, layer):
        scale, points = 1, []
        for line in self.streams[layer].splitlines():
            words = line.split()
            if "cm" in words:
                scale = float(words[0]) * 25.4 / 72
            elif words and words[-1] in "ml" and len(words) == 3:
                if words[-1] == "m":
                    points = []
                points.append((float(words[0]) * scale, float(words[1]) * scale))
            elif line in ("s", "S"):
                yield points, line == "s"


class Dxf:
    def __init__(self, name):
        self.document = ezdxf.readfile(name)
        audit = self.document.audit()
        require(not audit.errors and not audit.fixes, "ezdxf finds errors in the DXF")
        require(self.document.dxfversion == "AC1015", "the DXF is not AC1015")
        require(self.document.header["$INSUNITS"] == 4, "the DXF declares no mm")
        self.layers = [layer.dxf.name for layer in self.document.layers]

    def lines(self, layer):
        for e in self.document.modelspace().query(f'LWPOLYLINE[layer=="{layer}"]'):
            yield [(p[0], p[1]) for p in e.get_points("xy")], e.closed


def distance(p, q):
    return ((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2) ** 0.5


def check_layers(svg, pdf, dxf):
    require(list(svg.layers) and sorted(svg.layers) == sorted(LAYERS), "the layers of the SVG")
    require(sorted(pdf.names.values()) == sorted(LAYERS), "the layers of the PDF")
    require(sorted(pdf.streams) == sorted(LAYERS), "what the PDF draws in layers")
    require(all(layer in dxf.layers for layer in LAYERS), "the layers of the DXF")


def check_outlines(svg, pdf, dxf, parts):
    reference = list(svg.lines("CUT"))
    require(len(reference) == parts, f"{len(reference)} outlines for {parts} parts")
    for other in (pdf, dxf):
        found = list(other.lines("CUT"))
        require(len(found) == parts and all(closed for _, closed in found), "outlines are not closed")
        for (a, _), (b, _) in zip(reference, found):
            require(len(a) == len(b), "outlines differ")
            worst = max(distance(p, q) for p, q in zip(a, b))
            require(worst < 1e-6, f"outlines are {worst} mm apart in {type(other).__name__}")


def check_hundred(drawing):
    sides = [distance(*points) for points, _ in drawing.lines("MOUNTAIN") if len(points) == 2]
    require(len(sides) > 5, "no folds drawn")
    for side in sides:
        require(abs(side - 100) < 0.01, f"a side of 100 mm measures {side} mm in {type(drawing).__name__}")


def print_net(plico, net, stem, *options):
    names = [stem + ext for ext in (".svg", ".pdf", ".dxf")]
    run(plico, "print", net, "-qf", *options, *(x for name in names for x in ("-o", name)))
    return names


def main():
    plico, net = (os.path.abspath(p) for p in sys.argv[1:3])
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        options = ["--longest", "100mm", "--page", "A2"]
        names = print_net(plico, net, "cube", *options)
        svg, pdf, dxf = Svg(names[0]), Pdf(names[1]), Dxf(names[2])
        check_layers(svg, pdf, dxf)
        check_outlines(svg, pdf, dxf, 1)
        for drawing in (svg, pdf, dxf):
            check_hundred(drawing)
        require(svg.size == (420, 594), "the page of the SVG is not A2")
        require(all(abs(a - b) < 0.01 for a, b in zip(pdf.size, (420, 594))), "the page of the PDF is not A2")
        require(svg.texts.count("7") == 2 and pdf.text.split().count("7") == 2, "edge ids are no text")
        require("100 mm" in pdf.text and "print at 100 %" in pdf.text, "no ruler")
        again = print_net(plico, net, "again", *options, "--threads", "2", "--title", "cube")
        first = print_net(plico, net, "first", *options, "--threads", "1", "--title", "cube")
        for a, b in zip(again, first):
            require(open(a, "rb").read() == open(b, "rb").read(), f"{a} and {b} differ")
    print("pages read by xmllint, qpdf, pdfinfo, pdftotext and ezdxf")


main()
