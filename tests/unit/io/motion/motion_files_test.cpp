// Animation, robot models, table: what they say is the motion itself.
#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "linkage_samples.h"
#include "plico/base/error.h"
#include "plico/fold/plain_hinges.h"
#include "plico/io/motion/csv.h"
#include "plico/io/motion/gltf.h"
#include "plico/io/motion/mjcf.h"
#include "plico/io/motion/panel_joints.h"
#include "plico/io/motion/urdf.h"

namespace plico {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// Four squares around one corner; only the two creases along y fold, so the loop closes all the way.
CreasePattern cross_sheet() {
  CreasePattern sheet;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) sheet.vertices.emplace_back(x, y);
  sheet.faces = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}};
  const double turn = radians(90);
  sheet.edges = {{1, 4, Assignment::Valley, turn},
                 {4, 7, Assignment::Valley, turn},
                 {3, 4, Assignment::Flat, 0},
                 {4, 5, Assignment::Flat, 0}};
  return sheet;
}

// A player of our own: reads a .glb and says where the points of each mesh node are.
class GlbPlayer {
 public:
  explicit GlbPlayer(const std::string& glb) {
    const auto length = number<std::uint32_t>(glb, 12);
    json_ = json::parse(glb.substr(20, length));
    binary_ = glb.substr(20 + length + 8);
    EXPECT_EQ(glb.size(), number<std::uint32_t>(glb, 8));
    EXPECT_EQ(json_["buffers"][0]["byteLength"], binary_.size());
  }
  const json& document() const { return json_; }

  std::vector<std::vector<Vec3>> points(double seconds) const {
    std::vector<std::vector<Vec3>> result(json_["meshes"].size());
    place(json_["scenes"][0]["nodes"][0], Eigen::Affine3d::Identity(), seconds, result);
    return result;
  }
  std::vector<double> values(int accessor, int width) const {
    const json& a = json_["accessors"][accessor];
    const std::size_t start = json_["bufferViews"][a["bufferView"].get<int>()]["byteOffset"].get<std::size_t>() +
                              a.value("byteOffset", std::size_t{0});
    std::vector<double> result;
    for (int i = 0; i < a["count"].get<int>() * width; ++i) result.push_back(number<float>(binary_, start + 4 * i));
    return result;
  }

 private:
  template <class T>
  static T number(const std::string& bytes, std::size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  }
  static Eigen::Quaterniond quaternion(const double* q) { return Eigen::Quaterniond(q[3], q[0], q[1], q[2]); }

  Eigen::Quaterniond rotation(int node, double seconds) const {
    for (const json& channel : json_["animations"][0]["channels"]) {
      if (channel["target"]["node"] != node) continue;
      const json& sampler = json_["animations"][0]["samplers"][channel["sampler"].get<int>()];
      const std::vector<double> times = values(sampler["input"], 1), turns = values(sampler["output"], 4);
      std::size_t k = 0;
      while (k + 2 < times.size() && times[k + 1] <= seconds) ++k;
      const double s = std::clamp((seconds - times[k]) / (times[k + 1] - times[k]), 0.0, 1.0);
      return quaternion(&turns[4 * k]).slerp(s, quaternion(&turns[4 * k + 4]));  // along the shorter arc, as viewers do
    }
    const json& still = json_["nodes"][node];
    if (!still.contains("rotation")) return Eigen::Quaterniond::Identity();
    const auto q = still["rotation"].get<std::vector<double>>();
    return quaternion(q.data());
  }
  void place(int id, Eigen::Affine3d frame, double seconds, std::vector<std::vector<Vec3>>& result) const {
    const json& node = json_["nodes"][id];
    if (node.contains("translation")) {
      const auto t = node["translation"].get<std::vector<double>>();
      frame.translate(Vec3(t[0], t[1], t[2]));
    }
    frame.rotate(rotation(id, seconds));
    if (node.contains("scale")) frame.scale(node["scale"][0].get<double>());
    if (node.contains("mesh")) {
      const int mesh = node["mesh"];
      const auto p = values(json_["meshes"][mesh]["primitives"][0]["attributes"]["POSITION"], 3);
      for (std::size_t i = 0; i < p.size(); i += 3) result[mesh].push_back(frame * Vec3(p[i], p[i + 1], p[i + 2]));
    }
    for (int child : node.value("children", std::vector<int>{})) place(child, frame, seconds, result);
  }

  json json_;
  std::string binary_;
};

void expect_same_motion(const Linkage& linkage, const FoldingPath& path) {
  const GlbPlayer player(write_glb(linkage, path, {.metres_per_unit = 1, .seconds = 2}));
  for (double time : {0.0, 0.3, 0.5, 0.8, 1.0}) {
    SCOPED_TRACE(time);
    const auto shown = player.points(2 * time);
    const auto poses = folding_map(linkage, path.at(time));
    for (int p = 0; p < linkage.num_panels(); ++p)
      for (std::size_t i = 0; i < linkage.panels[p].size(); ++i) {
        const Vec3 at = poses[p] * linkage.panels[p][i];
        EXPECT_LT((shown[p][i] - Vec3(at.x(), at.z(), -at.y())).norm(), 2e-5);  // floats; y is up
      }
  }
}

TEST(Glb, ShowsTheMotionOfANet) {
  Rng rng(3);
  const Linkage linkage = make_linkage(random_triangles(30, 3, rng));
  expect_same_motion(linkage, linear_path(linkage));
  expect_same_motion(linkage, uniform_path(linkage));
}

// A chain of five thick squares, and a motion of it through random angles up to 180 degrees.
struct ThickChain {
  Linkage linkage;
  FoldingPath path;
};
ThickChain thick_chain() {
  ThickChain chain;
  chain.linkage = thick_hinged(make_linkage(square_strip({1, -1, 1, -1}), {}, 0), 0.1, 0.1);
  Rng rng(5);
  for (int k = 0; k <= 4; ++k) {
    Configuration config(chain.linkage.num_hinges());
    for (double& angle : config) angle = (2 * rng.uniform() - 1) * kPi;
    chain.path.waypoints.push_back({k / 4.0, config});
  }
  return chain;
}

TEST(Glb, AThickHingeIsThreePlainOnes) {
  const ThickChain chain = thick_chain();
  const GlbPlayer player(write_glb(plain_hinged(chain.linkage), plain_path(chain.path), {.metres_per_unit = 1}));
  for (double time : {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
    const auto shown = player.points(4 * time);
    const auto poses = folding_map(chain.linkage, chain.path.at(time));
    for (int p = 0; p < chain.linkage.num_panels(); ++p)
      for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 corner = poses[p] * Vec3(chain.linkage.panels[p][i] + 0.05 * Vec3::UnitZ());
        const auto is_corner = [&](const Vec3& at) {
          return (at - Vec3(corner.x(), corner.z(), -corner.y())).norm() < 2e-5;
        };
        EXPECT_TRUE(std::ranges::any_of(shown[p], is_corner)) << time << ", corner " << i << " of panel " << p;
      }
  }
}

// Where the links of a URDF are at the given joint angles, read from its text alone.
std::map<std::string, Pose> link_poses(const std::string& urdf, const Configuration& angles) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(urdf.c_str()));
  const auto vector = [](const char* text) {
    Vec3 v;
    EXPECT_EQ(std::sscanf(text, "%lf %lf %lf", &v.x(), &v.y(), &v.z()), 3);
    return v;
  };
  std::map<std::string, Pose> poses{{"panel_0", Pose::Identity()}};
  const pugi::xml_node robot = document.child("robot");
  for (bool more = true; more;) {
    more = false;
    for (const pugi::xml_node& joint : robot.children("joint")) {
      const std::string parent = joint.child("parent").attribute("link").value();
      const std::string child = joint.child("child").attribute("link").value();
      if (!poses.contains(parent) || poses.contains(child)) continue;
      const int hinge = std::atoi(joint.attribute("name").value() + std::strlen("hinge_"));
      EXPECT_GE(angles[hinge], joint.child("limit").attribute("lower").as_double() - 1e-6);
      EXPECT_LE(angles[hinge], joint.child("limit").attribute("upper").as_double() + 1e-6);
      Pose step = Pose::Identity();
      step.translate(vector(joint.child("origin").attribute("xyz").value()));
      step.rotate(Eigen::AngleAxisd(angles[hinge], vector(joint.child("axis").attribute("xyz").value())));
      poses[child] = poses[parent] * step;
      more = true;
    }
  }
  return poses;
}

TEST(Urdf, PanelsOfAThickChainAreWhereTheFoldingMapHasThem) {
  const ThickChain chain = thick_chain();
  const Linkage plain = plain_hinged(chain.linkage);
  const std::string urdf = write_urdf(plain, plain_path(chain.path), {.metres_per_unit = 1}).text;
  for (double time = 0; time <= 1; time += 0.0625) {
    const Configuration config = chain.path.at(time);
    const std::map<std::string, Pose> links = link_poses(urdf, plain_angles(config));
    const std::vector<Pose> poses = folding_map(chain.linkage, config);
    for (int p = 1; p < chain.linkage.num_panels(); ++p) {
      // A link's frame is where its joint is in the flat state.
      const Vec3 origin = plain.hinges[plain.parent_hinge[p]].from;
      const Pose& link = links.at("panel_" + std::to_string(p));
      EXPECT_LT((link.linear() - poses[p].linear()).norm(), 1e-5) << p;
      EXPECT_LT((link.translation() - poses[p] * origin).norm(), 1e-5) << p;
    }
  }
}

TEST(Glb, TurnsByHalfATurnAndByMoreTheRightWay) {
  const Linkage linkage = make_linkage(square_strip({kPi, -kPi, kPi}));
  expect_same_motion(linkage, linear_path(linkage));
  expect_same_motion(linkage, path_through({{0, {-kPi, 0, kPi}}, {1, {kPi, 0, -kPi}}}));
}

TEST(Glb, LoopsFollowTheTree) {
  const Linkage linkage = make_linkage(cross_sheet());
  ASSERT_TRUE(linkage.has_loops());
  expect_same_motion(linkage, linear_path(linkage));
}

TEST(Glb, HingesThatMoveTogetherShareTheirTimes) {
  const Linkage linkage = make_linkage(square_strip({1, 1, 1, 1}));
  const GlbPlayer player(write_glb(linkage, linear_path(linkage)));
  const json& samplers = player.document()["animations"][0]["samplers"];
  ASSERT_EQ(samplers.size(), 4u);
  for (const json& sampler : samplers) EXPECT_EQ(sampler["input"], samplers[0]["input"]);
  EXPECT_THAT(player.values(samplers[0]["input"], 1), ElementsAre(0, 4));
}

TEST(Glb, ThickPanelsHaveWalls) {
  Linkage linkage = make_linkage(square_strip({1}));
  linkage.thickness = 0.1;
  const GlbPlayer player(write_glb(linkage, linear_path(linkage)));
  EXPECT_EQ(player.document()["meshes"][0]["primitives"].size(), 3u);
  EXPECT_NEAR(player.document()["accessors"][0]["max"][2].get<double>(), 0.05, 1e-7);
}

TEST(Glb, RejectsWhatCannotBePlayed) {
  const Linkage linkage = make_linkage(square_strip({1}));
  EXPECT_THROW(write_glb(linkage, linear_path(linkage), {.seconds = 0}), InvalidOption);
  EXPECT_THROW(write_glb(Linkage{}, FoldingPath{}), InvalidInput);
}

TEST(TrajectoryCsv, HasAColumnAHingeInDegrees) {
  EXPECT_EQ(write_trajectory_csv(path_through({{0, {0, 0}}, {0.25, {kPi / 2, 0}}, {1, {kPi, -kPi}}})),
            "time,hinge_0_deg,hinge_1_deg\n0,0,0\n0.25,90,0\n1,180,-180\n");
  std::vector<Hinge> hinges(2);
  hinges[0].a = 3, hinges[0].b = 7;
  EXPECT_EQ(write_trajectory_csv(path_through({{0, {0, 0}}, {1, {0, kPi}}}), hinges),
            "time,crease_3_7_deg,hinge_1_deg\n0,0,0\n1,0,180\n");
}

TEST(AngleKeys, OfAStraightMotionAreItsEnds) {
  const FoldingPath path = path_through({{0, {0, 0}}, {0.5, {1, 1}}, {1, {2, 1}}});
  EXPECT_EQ(angle_keys(path, 0).size(), 2u);
  EXPECT_EQ(angle_keys(path, 1).size(), 3u);
}

TEST(PanelBody, OfASquarePlateIsTheTextbooks) {
  Linkage linkage = make_linkage(square_strip({1}));
  linkage.thickness = 0.5;
  const PanelBody body = panel_body(linkage, 1, Vec3(1, 0, 0), {.metres_per_unit = 1, .grams_per_square_metre = 12000});
  EXPECT_NEAR(body.mass, 12, 1e-12);
  EXPECT_LT((body.centre - Vec3(0.5, 0.5, 0)).norm(), 1e-12);
  EXPECT_NEAR(body.inertia(0, 0), 1.25, 1e-12);  // m (1 + t^2) / 12
  EXPECT_NEAR(body.inertia(1, 1), 1.25, 1e-12);
  EXPECT_NEAR(body.inertia(2, 2), 2, 1e-12);
  EXPECT_NEAR(body.inertia(0, 1), 0, 1e-12);
}

TEST(PanelBody, OfANeedleIsPositiveDefinite) {
  CreasePattern sheet;
  sheet.vertices = {{0, 0}, {100, 1}, {100, 1.0001}};
  sheet.faces = {{0, 1, 2}};
  const PanelBody body = panel_body(make_linkage(sheet), 0, Vec3::Zero(), {});
  const Vec3 moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia).eigenvalues();
  EXPECT_GT(moments[0], 0);
  EXPECT_GE(moments[0] + moments[1], moments[2] * (1 - 1e-9));  // as of any body
}

TEST(PanelBody, OfAPanelWithoutAreaIsAnError) {
  CreasePattern sheet;
  sheet.vertices = {{0, 0}, {1, 0}, {2, 0}};
  sheet.faces = {{0, 1, 2}};
  EXPECT_THROW(panel_body(make_linkage(sheet), 0, Vec3::Zero(), {}), InvalidInput);
}

TEST(Urdf, LimitsRunFromFlatToTheGoalAndAsFarAsThePathGoes) {
  const Linkage linkage = make_linkage(square_strip({1, -1}));
  const RobotFile file = write_urdf(linkage, path_through({{0, {0, 0}}, {0.5, {1.5, 0}}, {1, {1, -1}}}));
  EXPECT_THAT(file.text, HasSubstr("lower=\"0\" upper=\"1.5\""));
  EXPECT_THAT(file.text, HasSubstr("lower=\"-1\" upper=\"0\""));
  EXPECT_THAT(file.warnings, IsEmpty());
}

TEST(RobotModels, JointsTurnNoFartherThanTheMaterialAndRefuseAMotionThatDoes) {
  Linkage linkage = make_linkage(square_strip({1, -1}));
  linkage.hinges[0].high = 0.5;
  linkage.hinges[1].low = -0.25;
  const FoldingPath kept = path_through({{0, {0, 0}}, {1, {0.5, -0.25}}});
  EXPECT_THAT(write_urdf(linkage, kept).text, HasSubstr("lower=\"0\" upper=\"0.5\""));
  EXPECT_THAT(write_urdf(linkage, kept).text, HasSubstr("lower=\"-0.25\" upper=\"0\""));
  EXPECT_THAT(write_mjcf(linkage, kept).text, HasSubstr("range=\"0 0.5\""));
  EXPECT_THROW(write_urdf(linkage, linear_path(linkage)), InvalidInput);
  EXPECT_THROW(write_mjcf(linkage, linear_path(linkage)), InvalidInput);
  EXPECT_THROW(write_glb(linkage, linear_path(linkage)), InvalidInput);
}

TEST(Urdf, WarnsOfDeepChainsAndLoops) {
  const Linkage strip = make_linkage(square_strip(std::vector<double>(100, 0.1)));
  EXPECT_THAT(write_urdf(strip, linear_path(strip)).warnings, ElementsAre(HasSubstr("50 hinges")));
  const Linkage cross = make_linkage(cross_sheet());
  EXPECT_THAT(write_urdf(cross, linear_path(cross)).warnings, ElementsAre(HasSubstr("1 of 4 hinges close loops")));
}

TEST(Urdf, PartsHangOnABase) {
  CreasePattern sheet = square_strip({1});
  for (const Vec2& v : std::vector<Vec2>{{5, 0}, {6, 0}, {6, 1}}) sheet.vertices.push_back(v);
  sheet.faces.push_back({6, 7, 8});
  const Linkage linkage = make_linkage(sheet);
  const std::string text = write_urdf(linkage, linear_path(linkage)).text;
  EXPECT_THAT(text, HasSubstr("<link name=\"base\"/>"));
  EXPECT_THAT(text, HasSubstr("<child link=\"panel_2\"/>"));
}

TEST(Urdf, NameMustBePlain) {
  const Linkage linkage = make_linkage(square_strip({1}));
  EXPECT_THROW(write_urdf(linkage, linear_path(linkage), {.name = "a\"b"}), InvalidOption);
}

TEST(Mjcf, LoopsAreHeldAtBothEndsOfTheirHinge) {
  const Linkage linkage = make_linkage(cross_sheet());
  const std::string text = write_mjcf(linkage, linear_path(linkage)).text;
  std::size_t connects = 0;
  for (std::size_t at = 0; (at = text.find("<connect", at)) != std::string::npos; ++at) ++connects;
  EXPECT_EQ(connects, 2 * linkage.loop_hinges.size());
  EXPECT_THAT(text, HasSubstr("<exclude body1=\"panel_0\" body2=\"panel_3\"/>"));  // they share the middle
}

// Where the bodies of an MJCF file are at one of its keyframes, read from its text alone. Joints have the order of the
// bodies that hold them.
class MjcfPlayer {
 public:
  explicit MjcfPlayer(const std::string& text) { EXPECT_TRUE(document_.load_string(text.c_str())); }

  std::map<std::string, Pose> poses(std::size_t keyframe) {
    pugi::xml_node key = root().child("keyframe").child("key");
    while (keyframe-- > 0) key = key.next_sibling("key");
    std::istringstream angles(key.attribute("qpos").value());
    angles_.assign(std::istream_iterator<double>(angles), {});
    next_ = 0;
    poses_.clear();
    for (const pugi::xml_node& body : root().child("worldbody").children("body")) place(body, Pose::Identity());
    EXPECT_EQ(next_, angles_.size());
    return poses_;
  }

 private:
  pugi::xml_node root() const { return document_.child("mujoco"); }
  static Vec3 vector(const pugi::xml_attribute& text) {
    Vec3 v = Vec3::Zero();
    EXPECT_EQ(std::sscanf(text.value(), "%lf %lf %lf", &v.x(), &v.y(), &v.z()), 3);
    return v;
  }
  void place(const pugi::xml_node& body, Pose pose) {
    pose.translate(vector(body.attribute("pos")));
    if (const pugi::xml_node joint = body.child("joint"))
      pose.rotate(Eigen::AngleAxisd(angles_.at(next_++), vector(joint.attribute("axis"))));
    poses_[body.attribute("name").value()] = pose;
    for (const pugi::xml_node& child : body.children("body")) place(child, pose);
  }

  pugi::xml_document document_;
  std::vector<double> angles_;
  std::size_t next_ = 0;
  std::map<std::string, Pose> poses_;
};

TEST(Mjcf, PanelsOfAThickChainAreWhereTheFoldingMapHasThem) {
  const ThickChain chain = thick_chain();
  const Linkage plain = plain_hinged(chain.linkage);
  MjcfPlayer player(write_mjcf(plain, plain_path(chain.path), {.metres_per_unit = 1}).text);
  const FoldingPath path = plain_path(chain.path);
  for (std::size_t k = 0; k < path.waypoints.size(); ++k) {
    const std::map<std::string, Pose> bodies = player.poses(k);
    const std::vector<Pose> poses = folding_map(chain.linkage, chain.path.at(path.waypoints[k].time));
    for (int p = 1; p < chain.linkage.num_panels(); ++p) {
      const Vec3 origin = plain.hinges[plain.parent_hinge[p]].from;
      const Pose& body = bodies.at("panel_" + std::to_string(p));
      EXPECT_LT((body.linear() - poses[p].linear()).norm(), 1e-5) << k << " " << p;
      EXPECT_LT((body.translation() - poses[p] * origin).norm(), 1e-5) << k << " " << p;
    }
  }
}

TEST(Mjcf, KeyframesAreThePath) {
  const Linkage linkage = make_linkage(square_strip({1}));
  const std::string text = write_mjcf(linkage, path_through({{0, {0}}, {0.25, {0.5}}, {1, {1}}})).text;
  EXPECT_THAT(text, HasSubstr("time=\"1\" qpos=\"0.5\" ctrl=\"0.5\""));
  EXPECT_THAT(text, HasSubstr("time=\"4\" qpos=\"1\" ctrl=\"1\""));
  EXPECT_THAT(text, Not(HasSubstr("<equality>")));
}

}  // namespace
}  // namespace plico
