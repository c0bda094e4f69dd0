# How many square millimetres of a page, rendered to PPM at 127 dots per inch, have each colour:
#   count_colors.py PAGE.ppm 'rrggbb' ...
import sys

data = open(sys.argv[1], 'rb').read()
fields = data.split(maxsplit=4)
pixels = fields[4][-3 * int(fields[1]) * int(fields[2]):]
count = {}
for i in range(0, len(pixels), 3):
    color = pixels[i:i + 3]
    count[color] = count.get(color, 0) + 1
for word in sys.argv[2:]:
    print(word, round(count.get(bytes.fromhex(word), 0) / 25))
