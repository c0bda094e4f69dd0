#include "plico/io/pattern/pattern_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "plico/base/error.h"
#include "plico/io/pattern/cp.h"
#include "plico/io/pattern/opx.h"
#include "plico/io/pattern/svg_pattern.h"

namespace plico {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct Refusal {
  std::string code, where, suggestion;
};

Refusal refusal(const std::string& bytes, const std::string& name) {
  try {
    read_pattern(bytes, name);
  } catch (const InvalidInput& error) {
    EXPECT_STRNE(error.what(), "");
    return {error.code(), error.where(), error.suggestion()};
  }
  return {"accepted", "", ""};
}

int count(const CreasePattern& sheet, Assignment assignment) {
  return static_cast<int>(std::count_if(sheet.edges.begin(), sheet.edges.end(),
                                        [&](const Crease& e) { return e.assignment == assignment; }));
}

// A square with one valley from the top left corner of the screen to the middle of its right side: no mirror image of
// it looks the same.
const char* const kChiralCp =
    "1 -200 -200 200 -200\n1 200 -200 200 200\n1 200 200 -200 200\n1 -200 200 -200 -200\n3 -200 -200 200 0\n";

TEST(PatternFile, CpIsReadAsItLooksOnTheScreen) {
  const PatternFile pattern = read_pattern(kChiralCp, "chiral.cp");
  const CreasePattern& sheet = pattern.file.net.sheet;
  ASSERT_EQ(sheet.num_faces(), 2);
  EXPECT_EQ(count(sheet, Assignment::Boundary), 5);  // the right side is split at the crease's end
  for (const Crease& e : sheet.edges) {
    if (e.assignment != Assignment::Valley) continue;
    EXPECT_EQ(e.fold_angle, kPi);
    EXPECT_EQ(sheet.vertices[e.a], Vec2(-200, 200));  // top left with y up
    EXPECT_EQ(sheet.vertices[e.b], Vec2(200, 0));
  }
  EXPECT_THAT(pattern.notes, Contains(HasSubstr("1 line was split where another ends on it")));
  EXPECT_THAT(pattern.notes, Contains(HasSubstr("no fold angles")));
}

TEST(PatternFile, CpIsWrittenToTheSameSheet) {
  const CreasePattern sheet = read_cp(kChiralCp).sheet;
  const ImportedPattern again = read_cp(write_cp(sheet));
  EXPECT_EQ(again.sheet.vertices, sheet.vertices);
  EXPECT_EQ(again.sheet.faces, sheet.faces);
  EXPECT_THAT(again.notes, SizeIs(1));  // nothing was mended; only the missing angles are told
}

TEST(PatternFile, CrossingLinesAreSplitAndDoublesDropped) {
  const PatternFile pattern = read_pattern(
      "1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4\n1 0 4 0 0\n2 0 0 4 4\n3 4 0 0 4\n2 4 4 0 0\n4 0 0 4 4\n2 1 1 1 1\n", "x.cp");
  const CreasePattern& sheet = pattern.file.net.sheet;
  EXPECT_EQ(sheet.num_vertices(), 5);
  EXPECT_EQ(sheet.num_faces(), 4);
  EXPECT_EQ(count(sheet, Assignment::Mountain), 2);
  EXPECT_EQ(count(sheet, Assignment::Valley), 2);
  EXPECT_THAT(pattern.notes, Contains("1 point where lines cross became a vertex"));
  EXPECT_THAT(pattern.notes, Contains("1 line drawn twice was kept once"));
  EXPECT_THAT(pattern.notes, Contains(HasSubstr("of another kind and was left out (first at line 8)")));
  EXPECT_THAT(pattern.notes, Contains(HasSubstr("1 line no longer than")));
}

TEST(PatternFile, CpErrorsNameFileAndLine) {
  EXPECT_EQ(refusal("1 0 0 1 0\n7 0 0 1 1\n", "a.cp").code, "cp/type");
  EXPECT_EQ(refusal("1 0 0 1 0\n7 0 0 1 1\n", "a.cp").where, "a.cp:2");
  EXPECT_NE(refusal("7 0 0 1 1\n", "a.cp").suggestion, "");
  EXPECT_EQ(refusal("1 0 0 1\n", "a.cp").code, "read/truncated");
  EXPECT_EQ(refusal("1 0 0 1 nan\n", "a.cp").code, "read/number");
  EXPECT_EQ(refusal("2 0 0 1 1\n", "a.cp").code, "pattern/no-panel");
  EXPECT_NE(refusal("2 0 0 1 1\n", "a.cp").suggestion, "");
  EXPECT_EQ(refusal("# nothing\n", "a.cp").code, "pattern/empty");
  EXPECT_EQ(refusal("2 3 3 3 3\n", "a.cp").code, "pattern/empty");
  EXPECT_EQ(refusal("2 1e12 1e12 1000000000001 1e12\n", "a.cp").code, "pattern/far");
  EXPECT_EQ(refusal(" \n", "a.cp").code, "read/empty");
}

std::string opx_line(int type, double x0, double y0, double x1, double y1) {
  std::string text = "<object class=\"oripa.OriLineProxy\">";
  const auto field = [&](const char* key, double value) {
    if (value != 0) text += fmt::format("<void property=\"{}\"><double>{}</double></void>\n", key, value);
  };
  field("type", type);
  field("x0", x0), field("y0", y0), field("x1", x1), field("y1", y1);
  return text + "</object>\n";
}

std::string opx(const std::string& lines) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<java><object class=\"oripa.DataSet\"><void "
         "property=\"lines\">\n" +
         lines + "</void></object></java>\n";
}

TEST(PatternFile, OpxLeavesZerosOut) {
  const std::string text = opx(opx_line(1, 0, 0, 4, 0) + opx_line(1, 4, 0, 4, 4) + opx_line(1, 4, 4, 0, 4) +
                               opx_line(1, 0, 4, 0, 0) + opx_line(2, 0, 0, 4, 4) + opx_line(0, 4, 0, 0, 4));
  const PatternFile pattern = read_pattern(text, "square.opx");
  const CreasePattern& sheet = pattern.file.net.sheet;
  EXPECT_EQ(sheet.num_faces(), 4);
  EXPECT_EQ(count(sheet, Assignment::Mountain), 2);
  EXPECT_EQ(count(sheet, Assignment::Flat), 2);
  EXPECT_EQ(read_pattern(text, "-").file.net.sheet.vertices, sheet.vertices);  // known by its contents
}

TEST(PatternFile, OpxErrorsNameFileAndLine) {
  const Refusal type = refusal(opx(opx_line(1, 0, 0, 4, 0) + opx_line(5, 4, 0, 4, 4)), "a.opx");
  EXPECT_EQ(type.code, "opx/type");
  EXPECT_THAT(type.where, HasSubstr("a.opx:6"));
  EXPECT_NE(type.suggestion, "");
  EXPECT_EQ(refusal("<java><object>", "a.opx").code, "read/xml");
  EXPECT_EQ(refusal("<java/>", "a.opx").code, "pattern/empty");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  for (int i = 0; i < 100000; ++i) deep += "</a>";
  EXPECT_EQ(refusal(deep, "a.opx").code, "read/xml");
}

std::string svg(const std::string& body) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 100 100\">\n" + body + "\n</svg>";
}

const char* const kFrame = "<rect width=\"100\" height=\"100\" stroke=\"#000\" fill=\"none\"/>\n";

TEST(PatternFile, SvgStrokesHaveOrigamiSimulatorsMeaning) {
  const PatternFile pattern = read_pattern(svg(std::string(kFrame) +
                                               R"svg(<line x1="0" y1="10" x2="100" y2="10" stroke="#f00" opacity="0.5"/>
<line x1="0" y1="20" x2="100" y2="20" style="stroke: #0000FF; stroke-opacity: 0.25"/>
<path d="M0 30H100" stroke="yellow"/><path d="m0,40l100-0" stroke="rgb(255,0,255)"/>
<polyline points="0,50 100,50" stroke="lime"/><line x1="0" y1="60" x2="100" y2="60" stroke="gray"/>)svg"),
                                           "a.svg");
  const CreasePattern& sheet = pattern.file.net.sheet;
  EXPECT_EQ(sheet.num_faces(), 6);
  for (const Crease& e : sheet.edges) {
    if (e.assignment == Assignment::Mountain) {
      EXPECT_EQ(e.fold_angle, -kPi / 2);
      EXPECT_EQ(sheet.vertices[e.a], Vec2(0, -10));
    } else if (e.assignment == Assignment::Valley) {
      EXPECT_EQ(e.fold_angle, kPi / 4);
    } else {
      EXPECT_EQ(e.fold_angle, 0);
    }
  }
  for (const Assignment a :
       {Assignment::Mountain, Assignment::Valley, Assignment::Flat, Assignment::Unassigned, Assignment::Cut})
    EXPECT_EQ(count(sheet, a), 1) << static_cast<char>(a);
  EXPECT_THAT(pattern.notes, Contains(HasSubstr("1 shapes with no stroke, or one of another colour")));
  EXPECT_EQ(make_linkage(sheet).num_hinges(), 4);  // nothing turns about a cut
}

TEST(PatternFile, SvgStylesAndTransformsAreInherited) {
  const std::string text = svg(R"svg(<style>.m{stroke:#f00;opacity:.5} path { stroke : #000 }</style>
<g transform="translate(10,20) scale(2)"><path d="M0 0h10v10h-10z"/>
<g class="m" transform="rotate(90)"><line x1="0" y1="0" x2="10" y2="-10"/></g></g>)svg");
  const CreasePattern sheet = read_pattern(text, "a.svg").file.net.sheet;
  ASSERT_EQ(sheet.num_faces(), 2);
  ASSERT_EQ(count(sheet, Assignment::Mountain), 1);
  for (const Crease& e : sheet.edges)
    if (e.assignment == Assignment::Mountain) {
      EXPECT_EQ(e.fold_angle, -kPi / 2);
      EXPECT_NEAR((sheet.vertices[e.a] - Vec2(10, -20)).norm(), 0, 1e-12);
      EXPECT_NEAR((sheet.vertices[e.b] - Vec2(30, -40)).norm(), 0, 1e-12);
    }
}

TEST(PatternFile, SvgIsWrittenToTheSameSheet) {
  CreasePattern sheet = read_cp(kChiralCp).sheet;
  for (Crease& e : sheet.edges)
    if (e.assignment == Assignment::Valley) e.fold_angle = 1;
  const ImportedPattern again = read_svg_pattern(write_svg_pattern(sheet));
  EXPECT_THAT(again.notes, IsEmpty());
  EXPECT_EQ(again.sheet.vertices, sheet.vertices);
  EXPECT_EQ(again.sheet.faces, sheet.faces);
  for (int e = 0; e < sheet.num_edges(); ++e) {
    EXPECT_EQ(again.sheet.edges[e].assignment, sheet.edges[e].assignment);
    EXPECT_NEAR(again.sheet.edges[e].fold_angle, sheet.edges[e].fold_angle, 1e-15);
  }
}

TEST(PatternFile, SvgErrorsNameFileAndLine) {
  const auto code = [](const std::string& body) { return refusal(svg(kFrame + body), "a.svg").code; };
  EXPECT_EQ(refusal(svg(std::string(kFrame) + "<circle r='three' stroke='red'/>"), "a.svg").where, "a.svg:3");
  EXPECT_EQ(code("<path d='M0 0C1 1 2 2 3' stroke='red'/>"), "svg/path");
  EXPECT_EQ(code("<path d='M0 0a3 3 0 2 0 1 1' stroke='red'/>"), "svg/path");
  EXPECT_EQ(code("<rect width='-3' stroke='red'/>"), "svg/number");
  EXPECT_EQ(code("<use href='#nothing'/>"), "svg/use");
  EXPECT_EQ(code("<g id='a'><use href='#a'/></g>"), "read/xml");
  EXPECT_EQ(code("<path d='M0 0L1' stroke='red'/>"), "svg/path");
  EXPECT_EQ(code("<path d='M0 0?1 1' stroke='red'/>"), "svg/path");
  EXPECT_EQ(code("<line x1='two' stroke='red'/>"), "svg/number");
  EXPECT_EQ(code("<polygon points='0 0 1' stroke='red'/>"), "svg/number");
  EXPECT_EQ(code("<g transform='turn(3)'/>"), "svg/transform");
  EXPECT_EQ(code("<line stroke='red' x2='9' opacity='much'/>"), "svg/opacity");
  EXPECT_EQ(refusal("<html/>", "a.svg").code, "svg/root");
  EXPECT_EQ(refusal(svg("<text>hello</text>"), "a.svg").code, "svg/no-creases");
  EXPECT_EQ(refusal("<svg><g></svg>", "a.svg").code, "read/xml");
  EXPECT_EQ(refusal("<!DOCTYPE s [<!ENTITY a 'b'>]><svg>&a;</svg>", "a.svg").code, "svg/no-creases");
}

// Of the framed square, the letters of the edges that are not its border.
std::string letters_of(const std::string& stroke) {
  const std::string line = "<line y1='50' x2='100' y2='50' " + stroke + "/>";
  std::string letters;
  for (const Crease& e : read_svg_pattern(svg(kFrame + line)).sheet.edges)
    if (e.assignment != Assignment::Boundary) letters += static_cast<char>(e.assignment);
  return letters;
}

TEST(PatternFile, SvgColoursMayBeWrittenInAnyWay) {
  for (const char* red : {"#F00", "#ff0000ff", "Red", "rgb(255,0,0)", "rgb(100% 0% 0% / 1)", "hsl(0,100%,50%)",
                          "hsl(360deg 100% 50%)", " red ", "#ED1C24", "crimson"})
    EXPECT_EQ(letters_of(fmt::format("stroke='{}'", red)), "M") << red;
  for (const char* blue : {"blue", "hsl(240, 100%, 50%)", "#2E3192", "rgba(0,0,255,.5)"})
    EXPECT_EQ(letters_of(fmt::format("stroke='{}'", blue)), "V") << blue;
  EXPECT_EQ(letters_of("stroke='green'"), "C");
  EXPECT_EQ(letters_of("color='blue' stroke='currentColor'"), "V");
  for (const char* other : {"orange", "cyan", "gray", "none", "#12", "hsl(1,2)"})
    EXPECT_EQ(letters_of(fmt::format("stroke='{}'", other)), "") << other;
}

double angle_of(const std::string& stroke) {
  const std::string line = "<g opacity='0.5'><line y1='50' x2='100' y2='50' stroke='blue' " + stroke + "/></g>";
  double angle = 0;
  for (const Crease& e : read_svg_pattern(svg(kFrame + line)).sheet.edges) angle = std::max(angle, e.fold_angle);
  return degrees(angle);
}

TEST(PatternFile, SvgOpacityIsTheFoldAngleAsOrigamiSimulatorReadsIt) {
  EXPECT_DOUBLE_EQ(angle_of("opacity='1'"), 90);
  EXPECT_DOUBLE_EQ(angle_of("opacity=' 0.50'"), 45);
  EXPECT_DOUBLE_EQ(angle_of("style='opacity : 50% '"), 45);
  EXPECT_DOUBLE_EQ(angle_of("stroke-opacity='.5'"), 45);
  EXPECT_DOUBLE_EQ(angle_of("opacity='.5' style='stroke:blue'"), 45);
}

TEST(PatternFile, SvgCurvesBecomeCreasesAndTheNoteSaysHowMany) {
  const std::string drawing = svg(kFrame + std::string("<path d='M0 50C 25 0 75 100 100 50' stroke='red'/>"));
  const ImportedPattern coarse = read_svg_pattern(drawing), fine = read_svg_pattern(drawing, "a", {.flatten = 0.01});
  EXPECT_THAT(coarse.notes, Contains(HasSubstr("1 curve became 22 straight lines, no farther than 0.25 from it")));
  EXPECT_EQ(count(coarse.sheet, Assignment::Mountain), 22);
  EXPECT_EQ(coarse.sheet.num_faces(), 2);
  EXPECT_GT(count(fine.sheet, Assignment::Mountain), 60);
}

TEST(PatternFile, SvgElementsAreDrawnWhereTheyAreUsed) {
  const std::string text = svg(kFrame + std::string(R"svg(<style>@import "a.css"; #cut line, .x { stroke : lime }
defs > .x.m { stroke: red !important } .m { stroke: yellow }</style>
<defs><line id="fold" class="m x" x2="100"/></defs><symbol id="cut"><path d="M0 0H100" stroke="blue"/></symbol>
<g><use href="#fold" y="25"/><use xlink:href="#fold" transform="translate(0 50)"/></g><use href="#cut" y="75"/>)svg"));
  const CreasePattern sheet = read_svg_pattern(text).sheet;
  EXPECT_EQ(sheet.num_faces(), 4);
  EXPECT_EQ(count(sheet, Assignment::Mountain), 2);
  EXPECT_EQ(count(sheet, Assignment::Valley), 1);
}

// The letters that a line gets which stands in <g class="v" id="rim"><g class="inner">, one a rule.
TEST(PatternFile, SvgSelectorsColourOnlyWhatStandsWhereTheySay) {
  const auto letter = [](const std::string& rules) {
    const std::string text =
        svg(kFrame + ("<style>" + rules + "</style><g class='v' id='rim'><g class='inner'>" +
                      "<line class='a b' x1='0' y1='30' x2='100' y2='30' stroke='#ff0'/></g></g>"));
    const CreasePattern sheet = read_svg_pattern(text).sheet;
    for (const Crease& e : sheet.edges)
      if (e.assignment != Assignment::Boundary) return static_cast<char>(e.assignment);
    return '-';
  };
  for (const char* fits : {"line", "*", ".v line", "g line", "g.v line.a", "#rim .b", ".inner > line", "g>g>line",
                           ".v > .inner > .a.b", "svg .v line", "path, .v .a", ".x, g line", "/* .m */ svg>g line"})
    EXPECT_EQ(letter(fits + std::string("{stroke:red}")), 'M') << fits;
  for (const char* not_here :
       {"path",          ".m line",    ".v > line",           "svg > line", "line .v",    "#cut line", ".inner .v line",
        "g > .v > line", "line:hover", ".v line:first-child", "[x1]",       "g + g line", "g ~ line",  "line::before",
        "> line",        "g >",        "g > > line",          ".",          "#",          "a|line",    "*line"})
    EXPECT_EQ(letter(not_here + std::string("{stroke:red}")), 'F') << not_here;
  EXPECT_EQ(letter("@media print { line { stroke: red } .v line { stroke: red } }"), 'F');
  EXPECT_EQ(letter("@media print { line { stroke: red } } line { stroke: blue }"), 'V');
  EXPECT_EQ(letter("@font-face { font-family: x } line { stroke: blue }"), 'V');
  EXPECT_EQ(letter(".v line { stroke: blue } line { stroke: red }"), 'V') << "the special one is above the general";
  EXPECT_EQ(letter("line { stroke: blue"), 'V') << "a block that is not closed ends with the sheet";
}

TEST(PatternFile, SvgRulesThatAreLeftOutAreTold) {
  const std::string text = svg(kFrame + std::string("<style>line:hover, .x + .y { stroke: red }</style>"));
  EXPECT_THAT(read_svg_pattern(text).notes, Contains(HasSubstr("2 rules of the style sheet were left out")));
}

TEST(PatternFile, WrongNamesGetAHint) {
  EXPECT_EQ(refusal(kChiralCp, "a.fold").suggestion, "rename the file: it looks like CP");
  EXPECT_EQ(read_pattern(kChiralCp, "-").file.net.sheet.num_faces(), 2);
}

}  // namespace
}  // namespace plico
