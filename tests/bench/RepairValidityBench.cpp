// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Repairs defective meshes with the program itself, file by file, and counts the sound ones: the written file is
// closed, manifold and oriented, has not more crossings than the input (rounded as it is), and the part is still there.
// Made meshes always; with HANDWHEEL_DATA also the scans in that folder. Some minutes.
#include "BuildPaths.h"
#include "bench/Bars.h"
#include "bench/MeshValidityJudge.h"
#include "document/formats/MeshFormat.h"
#include "support/MeshShapes.h"
#include "support/OneSidedShapes.h"
#include "support/TangledBall.h"

#include <CGAL/IO/STL.h>

#include <sys/resource.h>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

using namespace handwheel;

namespace {

constexpr rlim_t kLimitSeconds = 120;  // CPU time for one file: other programs do not affect it
constexpr int kPatienceMs = 1'800'000;
constexpr double kMostMoved = 0.01;  // fraction of the diagonal
// By how much of it the box may grow: a patch over a large hole of a ball rises out of it, one that runs away goes
// farther.
constexpr double kMostGrown = 0.15;

bench::Bars bars;

// Sheets and the views of a scanner from one side: to leave them open is right where the report says so.
bool mayStayOpen(const std::string& file) {
  for (const char* name : {"alligator", "lego", "annulus", "planar_mesh", "lato", "faccia", "rangemap"}) {
    if (file.find(name) != std::string::npos) return true;
  }
  return false;
}

bench::JudgedMesh rounded(const TriangleSoup& soup) {
  std::vector<std::array<double, 3>> positions;
  for (const Vec3& p : soup.points)
    positions.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
  std::vector<bench::JudgeTriangle> triangles;
  for (const Triangle& t : soup.triangles) triangles.push_back({t[0], t[1], t[2]});
  return {positions, triangles};
}

bench::JudgedMesh readByLibrary(const std::string& path) {
  std::vector<std::array<double, 3>> positions;
  std::vector<bench::JudgeTriangle> triangles;
  CGAL::IO::read_STL(path, positions, triangles);
  return {positions, triangles};
}

// Every loop was filled or says why not, and one says so.
bool saysWhatIsOpen(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return false;
  const auto report = nlohmann::json::parse(file.readAll().toStdString(), nullptr, false);
  if (report.is_discarded() || !report.contains("loops")) return false;
  bool isOpen = false;
  for (const auto& loop : report.at("loops")) {
    if (loop.value("outcome", "") == "filled") continue;
    isOpen = true;
    if (!loop.contains("reason")) return false;
  }
  return isOpen;
}

struct Verdict {
  bool crashed = false;
  bool sound = false;
  bool openAndSaid = false;
  bool moreCrossings = false;
  bool lostPart = false;
  bool grown = false;  // the box, by over 1 % of the diagonal
  bool isDefective = false;
};

Verdict judge(const std::string& name, const std::string& input, const TriangleSoup& soup) {
  const QTemporaryDir folder;
  const QString output = folder.filePath("repaired.stl"), report = folder.filePath("report.json");
  Verdict verdict;
  const bench::JudgedMesh before = rounded(soup);
  verdict.isDefective = !bench::judgeEdges(before).areSound();
  QProcess program;
  program.setChildProcessModifier([] {
    const rlimit limit{kLimitSeconds, kLimitSeconds};
    setrlimit(RLIMIT_CPU, &limit);
  });
  // Open sheets stay open unless asked; here everything is to be closed.
  program.start(test::programPath(),
                {"repair", QString::fromStdString(input), "-o", output, "--open-sheets", "back", "--report", report});
  if (!program.waitForFinished(kPatienceMs)) {
    program.kill();
    program.waitForFinished();
  }
  verdict.crashed = program.exitStatus() != QProcess::NormalExit || program.exitCode() > 2;
  const bench::JudgedMesh after =
      QFile::exists(output) ? readByLibrary(output.toStdString()) : bench::JudgedMesh({}, {});
  if (after.triangles.empty()) {
    verdict.lostPart = true;
    std::printf("  no file   %s\n", name.c_str());
    return verdict;
  }
  const bench::JudgedEdges edges = bench::judgeEdges(after);
  const std::size_t was = bench::judgeCrossings(before), is = bench::judgeCrossings(after);
  const bench::JudgedChange change = bench::judgeChange(before, after);
  verdict.moreCrossings = is > was;
  verdict.lostPart = change.lostParts > 0;
  verdict.grown = change.growth > 0.01;
  const bool isKept =
      !verdict.lostPart && !verdict.moreCrossings && change.farthest <= kMostMoved && change.growth <= kMostGrown;
  verdict.sound = isKept && edges.areSound();
  verdict.openAndSaid = isKept && !edges.areSound() && mayStayOpen(name) && saysWhatIsOpen(report);
  std::printf(
      "  %-9s %-60s open %zu, surplus %zu, turned %zu, crossings %zu -> %zu, moved %.2g %%, box %+.2g %%, lost %zu\n",
      verdict.sound         ? "sound"
      : verdict.openAndSaid ? "open"
                            : "UNSOUND",
      name.c_str(), edges.open, edges.surplus, edges.turned, was, is, 100.0 * change.farthest, 100.0 * change.growth,
      change.lostParts);
  std::fflush(stdout);
  return verdict;
}

struct Count {
  std::size_t refused = 0, files = 0, defective = 0, unsound = 0, openAndSaid = 0, crashed = 0, moreCrossings = 0,
              lostPart = 0, grown = 0;
  std::size_t spoilt = 0;  // sound before, not so after

  void add(const Verdict& v) {
    const bool isRight = v.sound || v.openAndSaid;
    ++files;
    defective += v.isDefective;
    unsound += v.isDefective && !isRight;
    openAndSaid += v.isDefective && v.openAndSaid;
    spoilt += !v.isDefective && !isRight;
    crashed += v.crashed;
    moreCrossings += v.moreCrossings;
    lostPart += v.lostPart;
    grown += v.grown;
  }

  // A file that our reader refuses is one that is not sound after a repair.
  void addRefused(const std::string& name) {
    std::printf("  %-9s %s\n", "REFUSED", name.c_str());
    ++files;
    ++refused;
    ++defective;
    ++unsound;
  }

  // mostUnsound: a share of the defective.
  void promise(benchmark::State& state, const std::string& what, double mostUnsound) const {
    state.counters["refused"] = static_cast<double>(refused);
    state.counters["files"] = static_cast<double>(files);
    state.counters["defective"] = static_cast<double>(defective);
    state.counters["openAndSaid"] = static_cast<double>(openAndSaid);
    state.counters["grown"] = static_cast<double>(grown);
    const auto row = [&](const char* text, double bar, std::size_t count) {
      bars.atMost(what + text, bar, static_cast<double>(count));
    };
    const auto of = static_cast<double>(defective);
    bars.atMost(what + ", of " + std::to_string(defective) + " defective: not sound after a repair (share)",
                mostUnsound, static_cast<double>(unsound) / of);
    row(", intact: not sound after a repair", 0.0, spoilt);
    row(": crashed or not done within 120 s of CPU time", 0.0, crashed);
    row(": more crossings than before", 0.0, moreCrossings);
    row(": a part lost", 0.0, lostPart);
  }
};

std::vector<std::pair<std::string, TriangleSoup>> madeMeshes() {
  std::vector<std::pair<std::string, TriangleSoup>> made{
      {"ball with holes", test::sphereWithHoles(4, 7, 0.3)},
      {"ball with a tangled hole", test::withFoldedBorder(test::sphereWithoutCap(4, 0.12))},
      {"ball without a third", test::sphereWithoutCap(5, 0.9)},
      {"bumpy ball without a cap", test::withHole(test::bumpySphere(5), Vec3(0, 0.8, 0.6), 0.4)},
      {"open tube", test::cylinder(60, 40, 1.0, 3.0, false)},
      {"torus with holes", test::withHole(test::withHole(test::torus(80, 40), {2.7, 0, 0}, 0.4), {-2, 0, 0.7}, 0.5)},
      {"cubes that share an edge", test::twoCubesSharingAnEdge()},
      {"cubes that share a corner", test::twoCubesSharingAVertex()},
      {"box with an inner wall", test::boxWithInnerWall()},
      {"sphere with a cross cap", test::sphereWithCrossCap(4)},
      {"ball of single triangles", test::unshared(test::sphereWithHoles(4, 3, 0.2))},
      {"ball inside out", test::turnedOver(test::sphereWithHoles(3, 2, 0.3))}};
  TriangleSoup half = test::icosphere(4);  // every third triangle turned over, some twice
  for (std::size_t i = 0; i < half.triangles.size(); i += 3) std::swap(half.triangles[i][0], half.triangles[i][1]);
  for (std::size_t i = 0; i < 40; ++i) half.triangles.push_back(half.triangles[13 * i]);
  made.emplace_back("ball with turned and double triangles", half);
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    made.emplace_back("blocks " + std::to_string(seed), test::randomBlocks(random, 40, 5));
  }
  return made;
}

void made(benchmark::State& state) {
  for (auto _ : state) {
    Count count;
    for (const auto& [name, soup] : madeMeshes()) {
      const QTemporaryDir folder;
      const std::string path = folder.filePath("a.stl").toStdString();
      std::ofstream(path, std::ios::binary) << writeMesh(soup, MeshFormat::Stl, NumberType::Float32);
      count.add(judge(name, path, soup));
    }
    count.promise(state, "made meshes", 0.0);
  }
}

bool isMesh(const std::filesystem::path& path) {
  static const std::set<std::string> kEndings{".stl", ".ply", ".obj", ".off", ".3mf"};
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return kEndings.contains(ending) && path.string().find("/malformed/") == std::string::npos;
}

// The scans, and the models of the package occt-misc where it is installed.
void scans(benchmark::State& state) {
  const char* data = std::getenv("HANDWHEEL_DATA");
  if (!data) return bars.missing(state, "scans", "HANDWHEEL_DATA is not set");
  std::set<std::filesystem::path> files;
  for (const std::filesystem::path& folder :
       {std::filesystem::path(data) / "scans", std::filesystem::path("/usr/share/opencascade/data/stl")}) {
    if (!std::filesystem::exists(folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && isMesh(entry.path())) files.insert(entry.path());
  }
  if (files.empty()) return bars.missing(state, "scans", std::string("none is in ") + data);
  for (auto _ : state) {
    Count count;
    for (const std::filesystem::path& file : files) {
      const auto read = readMeshFile(file, {});
      const std::string name = file.parent_path().filename().string() + "/" + file.filename().string();
      if (read)
        count.add(judge(name, file, read->soup));
      else
        count.addRefused(name);
    }
    count.promise(state, "scans", 14.0 / 64.0);  // 50 of 64 are to be sound
  }
}

}  // namespace

BENCHMARK(made)->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK(scans)->Unit(benchmark::kSecond)->Iterations(1);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
