# cmake -DPAGE=page.html -DSTYLE=style.css -DSCRIPT=page.js -DOUTPUT=viewer_template.inc -P embed_viewer.cmake
# Puts the viewer page into one string literal; only its data is missing.
cmake_minimum_required(VERSION 3.25)
file(READ "${PAGE}" page)
file(READ "${STYLE}" style)
file(READ "${SCRIPT}" script)
string(REPLACE "@STYLE@" "${style}" page "${page}")
string(REPLACE "@SCRIPT@" "${script}" page "${page}")
file(WRITE "${OUTPUT}" "R\"PLICO(${page})PLICO\"\n")
