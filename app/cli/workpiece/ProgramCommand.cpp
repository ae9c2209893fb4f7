// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/ProgramCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/workpiece/TurnedFigures.h"
#include "document/AtomicFile.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "machining/TurningFidelity.h"
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/ProgramSimulation.h"
#include "machining/program/ProgramWriter.h"
#include "machining/program/RoughAndFinish.h"
#include "machining/target/TargetDeviation.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr double kGouge = 0.005;  // mm, of the target that cycles may cut into

struct ProgramRequest {
  std::string from, output;
  ProgramDialect dialect = ProgramDialect::LinuxCnc;
  std::optional<StockCylinder> stock;  // of cycles for a target
  CycleSettings cycles;
  PassProgram passes;
};

struct NumberOption {
  const char* name;
  double* value;
  double least, largest;
};

std::string readProgramRequest(const Arguments& arguments, ProgramRequest& request) {
  request.from = arguments.operands[0];
  request.output = arguments.valueOf("output");
  if (request.output.empty()) return "The option -o P.ngc is missing.";
  const std::string dialect = arguments.has("dialect") ? arguments.valueOf("dialect") : "linuxcnc";
  if (dialect != "linuxcnc" && dialect != "fanuc") return "--dialect is linuxcnc or fanuc.";
  request.dialect = dialect == "fanuc" ? ProgramDialect::Fanuc : ProgramDialect::LinuxCnc;
  if (arguments.has("stock")) {
    request.stock = stockOf(arguments.valueOf("stock"));
    if (!request.stock) return "--stock is a bar such as cylinder:40x100.";
  }
  CycleSettings& c = request.cycles;
  const NumberOption numbers[] = {{"depth", &c.depth, 0.02, 100.0},
                                  {"allowance", &c.allowance, 0.0, 10.0},
                                  {"nose", &c.nose, TurningPass::kLeastNose, TurningPass::kLargestNose},
                                  {"rough-feed", &c.roughFeed, 1e-3, 10.0},
                                  {"finish-feed", &c.finishFeed, 1e-3, 10.0},
                                  {"speed", &c.speed, 1.0, 5000.0},
                                  {"max-rpm", &c.mostSpindle, 1.0, kMostSpindle},
                                  {"spindle", &request.passes.spindle, 1.0, kMostSpindle}};
  for (const NumberOption& option : numbers) {
    if (!arguments.has(option.name)) continue;
    const bool isGood = readNumber(arguments.valueOf(option.name), *option.value) && *option.value >= option.least &&
                        *option.value <= option.largest;
    if (!isGood)
      return std::string("--") + option.name + " takes a number from " + shortestText(option.least) + " to " +
             shortestText(option.largest) + ".";
  }
  return {};
}

// What a program makes of the bar, before it is given away: a sentence, or nothing where all is well.
std::string problemOf(const std::string& text, const TargetProfile& target, const ProgramRequest& request,
                      Progress progress) {
  ProgramSetup setup;
  setup.dialect = request.dialect;
  setup.standard = {request.cycles.nose, outsideOrientation(request.dialect), {0, 0}};
  setup.reference = {0.5 * request.stock->diameter + 100.0, 100.0};
  const Result<ToolPath> path = runProgram(text, setup, progress.part(0.0, 0.3));
  if (!path) return sentenceFor(path.error());
  ProgramSimulation simulation(TurnedProfile(*request.stock, turnSpacingSetting().standard), *path, setup);
  if (!simulation.run(progress.part(0.3, 0.8))) return "Cancelled.";
  if (simulation.collisionCount() > 0)
    return "The cycles collide in line " + std::to_string(simulation.collisions().front().line) +
           ": use a smaller nose or depth.";
  const TurnedProfile& part = simulation.part();
  const double base = target.upperEnd() - part.length();
  const TargetDeviation deviation = deviationFrom(target, part, base, progress.part(0.8, 1.0));
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double z = part.z(i) + base;
    if (z > target.lowerEnd() + part.spacing() && z < target.upperEnd() - part.spacing() &&
        deviation.outer[i] < -kGouge)
      return "The cycles cut " + roundedText(-deviation.outer[i], 3) + " mm into the target at Z " +
             roundedText(z - target.upperEnd(), 4) + ": use a smaller nose.";
  }
  return {};
}

struct Written {
  std::string text, problem;
  std::optional<Error> error;
};

Written cyclesFor(const ProgramRequest& request, const DocumentKinds& kinds, Progress progress) {
  const Result<TargetProfile> target = readTarget(request.from, kinds, progress.part(0.0, 0.2));
  if (!target) return {{}, {}, target.error()};
  const auto moves = roughAndFinish(*target, 0.5 * request.stock->diameter, request.cycles);
  if (!moves) return {{}, {}, moves.error()};
  Written written{programText(*moves, request.dialect, "rough and finish"), {}, {}};
  written.problem = problemOf(written.text, *target, request, progress.part(0.2, 1.0));
  return written;
}

Written passesOfFile(const ProgramRequest& request, const DocumentKinds& kinds, Progress progress) {
  const Result<OpenedFile> opened = kinds.open(request.from, {}, progress);
  if (!opened) return {{}, {}, opened.error()};
  const auto* const workpiece = dynamic_cast<const WorkpieceSnapshot*>(opened->content.get());
  if (!workpiece || !workpiece->part || workpiece->part->passes.empty())
    return {{}, request.from + " has no passes. With --stock cycles are made for it as a target.", {}};
  std::vector<TurningPass> passes;
  for (const auto& pass : workpiece->part->passes) {
    if (!isProgrammable(*pass))
      return {{},
              pass->tool ? "Passes of the tool " + pass->tool->id + " cannot be written as a program."
                         : "Passes in a bore cannot be written as a program.",
              {}};
    passes.push_back(*pass);
  }
  std::vector<std::string> tools;
  for (const PassTool& tool : toolsOf(passes)) tools.push_back(descriptionOf(tool, request.dialect));
  const StockCylinder& stock = workpiece->stock;
  const auto moves = movesOf(passes, 0.5 * stock.diameter, stock.length, request.passes);
  return {programText(moves, request.dialect, "recorded passes", tools), {}, {}};
}

int runProgramCommand(const Arguments& arguments, const DocumentKinds& kinds) {
  ProgramRequest request;
  if (const std::string problem = readProgramRequest(arguments, request); !problem.empty())
    return failUsage(problem, "program");
  if (const std::string refusal = refusalOfData("-o", request.output, {request.from}, kinds); !refusal.empty())
    return refuse(refusal);
  Written written;
  runInterruptible("Writing", [&](CommandJob& job) {
    written = request.stock ? cyclesFor(request, kinds, job.progress()) : passesOfFile(request, kinds, job.progress());
  });
  if (written.error) {
    if (written.error->subject.empty()) written.error->subject = request.from;
    return fail(*written.error);
  }
  if (!written.problem.empty()) return refuse(written.problem);
  if (const Status saved = writeFileAtomically(request.output, written.text); !saved) return fail(saved.error());
  return print("Wrote " + request.output + ".\n");
}

}  // namespace

Command programCommand() {
  return {
      {"program",
       "FROM",
       "Writes a program for a lathe: the passes of a workpiece or, with --stock, cycles that rough and finish the\n"
       "outside of a target (.dxf, .svg or a workpiece). The cycles are simulated first, and refused where they\n"
       "collide or cut into the target. The right end of the part is Z 0; X is a diameter.",
       {
           {"output", 'o', "P.ngc", "The program to write"},
           {"dialect", 0, "NAME", "linuxcnc (default) or fanuc, system A"},
           {"stock", 0, "cylinder:DxL", "The bar that the target is made of"},
           {"depth", 0, "MM", "Of a roughing cut, on the radius (default 1.5)"},
           {"allowance", 0, "MM", "Left for finishing (default 0.3)"},
           {"nose", 0, "MM", "Nose radius of the tools of cycles (default 0.4)"},
           {"rough-feed", 0, "MM", "Per revolution (default 0.25)"},
           {"finish-feed", 0, "MM", "Per revolution (default 0.08)"},
           {"speed", 0, "M/MIN", "Of the surface, in cycles (default 150)"},
           {"max-rpm", 0, "RPM", "Greatest speed of the spindle in cycles (default 2000)"},
           {"spindle", 0, "RPM", "Speed of the spindle for recorded passes (default 500)"},
           {"help", 'h', "", "Show this help"},
       },
       "FROM -o P.ngc [--dialect NAME] [--stock cylinder:DxL [--depth MM] [--nose MM] ...]"},
      runProgramCommand};
}

}  // namespace handwheel
