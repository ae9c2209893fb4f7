// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/ProgramCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/workpiece/BarStockArgument.h"
#include "cli/workpiece/PostArguments.h"
#include "cli/workpiece/TurnStatistics.h"
#include "document/AtomicFile.h"
#include "document/workpiece/PassesProgram.h"
#include "machining/TurningFidelity.h"
#include "machining/lathe/LatheJson.h"
#include "machining/program/cycles/BoreCuts.h"
#include "machining/program/cycles/CycleProgram.h"

#include <cmath>

namespace handwheel {

namespace {

struct ProgramRequest {
  std::string from, output, tools;
  ProgramDialect dialect = ProgramDialect::LinuxCnc;
  std::optional<StockCylinder> stock;  // for cycles for a target
  CycleSettings cycles;
  double facing = 0.0;  // mm, of the bar beyond the target
  bool choosesDrill = false;
  std::optional<ProgramPost> post;  // none: that of the document, or the usual one
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
  request.tools = arguments.valueOf("write-tools");
  request.choosesDrill = arguments.has("drill") && arguments.valueOf("drill") == "auto";
  const std::string dialect = arguments.has("dialect") ? arguments.valueOf("dialect") : "linuxcnc";
  if (dialect != "linuxcnc" && dialect != "fanuc") return "--dialect is linuxcnc or fanuc.";
  request.dialect = dialect == "fanuc" ? ProgramDialect::Fanuc : ProgramDialect::LinuxCnc;
  if (arguments.has("post") || arguments.has("insert")) {
    if (std::string problem = readPost(arguments, request.post.emplace()); !problem.empty()) return problem;
  }
  if (arguments.has("stock")) {
    BarStockArgument word = readBar(arguments.valueOf("stock"));
    if (!word.problem.empty()) return std::move(word.problem);
    if (!word.bar) return "--stock is a bar such as cylinder:40x100.";
    request.stock = word.bar;
  }
  CycleSettings& c = request.cycles;
  const NumberOption numbers[] = {{"depth", &c.depth, 0.02, 100.0},
                                  {"allowance", &c.allowance, 0.0, 10.0},
                                  {"nose", &c.nose, TurningPass::kLeastNose, TurningPass::kLargestNose},
                                  {"rough-feed", &c.roughFeed, 1e-3, 10.0},
                                  {"finish-feed", &c.finishFeed, 1e-3, 10.0},
                                  {"speed", &c.speed, 1.0, 5000.0},
                                  {"max-rpm", &c.mostSpindle, 1.0, kMostSpindle},
                                  {"drill", &c.drill, 0.0, 100.0},
                                  {"facing", &request.facing, 0.0, 100.0},
                                  {"spindle", &request.passes.spindle, 1.0, kMostSpindle}};
  for (const NumberOption& option : numbers) {
    if (!arguments.has(option.name) || (option.value == &c.drill && request.choosesDrill)) continue;
    const bool isGood = readNumber(arguments.valueOf(option.name), *option.value) && *option.value >= option.least &&
                        *option.value <= option.largest;
    if (!isGood)
      return std::string("--") + option.name + " takes a number from " + shortestText(option.least) + " to " +
             shortestText(option.largest) + ".";
  }
  return {};
}

struct Written {
  std::string text, problem;
  std::optional<Error> error;
  std::string tools = {};  // path of the tool table
  std::vector<std::string> warnings = {};
};

// Returns a warning about the material that cycles leave on the target; empty: no warning.
std::string warningOf(const CycleRest& rest, const TargetProfile& target, double drill, const LatheTools& tools) {
  if (!rest.isConsiderable()) return {};
  const std::string sentence = "The program leaves up to " + roundedText(rest.height, 3) + " mm over the target, " +
                               (rest.isInBore ? "in its bore at Z " : "at Z ") + roundedText(rest.z, 4) + ". ";
  if (!rest.isInBore || drill > 0.0) return sentence + "Cut the rest by hand, or by a program of your own.";
  if (const double fitting = drillFor(target, tools); fitting > 0.0)
    return sentence + "Add --drill " + roundedText(fitting, 3) + ".";
  const std::optional<Error> why = whyNoDrill(target, tools);
  return why ? sentence + "No drill makes it: " + why->arguments[2] + ". " + why->arguments[3] : sentence;
}

Written cyclesFor(const ProgramRequest& request, const DocumentKinds& kinds, Progress progress) {
  const Result<TargetProfile> target = readTarget(request.from, kinds, progress.part(0.0, 0.2));
  if (!target) return {{}, {}, target.error()};
  const TurnedProfile bar(*request.stock, turnSpacingSetting().standard);
  const LatheSetup lathe = defaultLatheSetup(*request.stock);
  const LatheTools tools = shippedLatheTools();
  const double base = target->upperEnd() + request.facing - bar.length();
  CycleTask task{*target, *request.stock, bar, base, lathe.chuck.grip, tools};
  task.allowance = request.facing;
  task.lathe = ProgramLathe{lathe.chuck, lathe.tailstock, nullptr};
  CycleSettings cycles = request.cycles;
  cycles.post = request.post.value_or(ProgramPost());
  const Progress rest = progress.part(0.2, 1.0);
  auto program = request.choosesDrill ? cycleProgramWithDrill(task, request.dialect, cycles, rest)
                                      : cycleProgram(task, request.dialect, cycles, rest);
  if (!program) return {{}, {}, program.error()};
  std::vector<std::string> warnings;
  if (std::string warning = warningOf(program->rest, *target, program->drill, tools); !warning.empty())
    warnings.push_back(std::move(warning));
  return {std::move(program->text), {}, {}, toolTableText(program->tools), std::move(warnings)};
}

Written passesOfFile(const ProgramRequest& request, const DocumentKinds& kinds, Progress progress) {
  const Result<OpenedFile> opened = kinds.open(request.from, {}, progress);
  if (!opened) return {{}, {}, opened.error()};
  const auto* const workpiece = dynamic_cast<const WorkpieceSnapshot*>(opened->content.get());
  if (!workpiece) return {{}, request.from + " is not a workpiece. With --stock cycles are made for a drawing.", {}};
  PassProgram how = request.passes;
  how.post = request.post.value_or(workpiece->programPost);
  const auto program = passesProgram(*workpiece, request.dialect, how);
  if (!program) return {{}, {}, program.error()};
  std::vector<std::string> warnings;
  for (const LeftOutPass& pass : program->leftOut) warnings.push_back("Left out: " + textOf(pass));
  return {program->text, {}, {}, toolTableText(program->tools), std::move(warnings)};
}

int runProgramCommand(const Arguments& arguments, const DocumentKinds& kinds) {
  ProgramRequest request;
  if (const std::string problem = readProgramRequest(arguments, request); !problem.empty())
    return failUsage(problem, "program");
  if (const std::string refusal = refusalOfData("-o", request.output, {request.from}, kinds); !refusal.empty())
    return refuse(refusal);
  if (!request.tools.empty()) {
    const std::string refusal = refusalOfData("--write-tools", request.tools, {request.from, request.output}, kinds);
    if (!refusal.empty()) return refuse(refusal);
  }
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
  if (!request.tools.empty()) {
    if (const Status saved = writeFileAtomically(request.tools, written.tools); !saved) return fail(saved.error());
  }
  for (const std::string& warning : written.warnings) complain(warning);
  return print("Wrote " + request.output + ".\n");
}

}  // namespace

Command programCommand() {
  CommandSpec spec = {
      "program",
      "FROM",
      "Writes a program for a lathe: the passes of a workpiece or, with --stock, cycles that rough and finish a\n"
      "target (.dxf, .svg or a workpiece). The cycles are simulated first, and refused where they\n"
      "collide or cut into the target. The right end of the part is Z 0; X is a diameter.",
      {
          {"output", 'o', "P.ngc", "The program to write"},
          {"dialect", 0, "NAME", "Dialect of the program: linuxcnc (default) or fanuc, system A"},
          {"stock", 0, "cylinder:DxL", "The bar that the target is made of"},
          {"depth", 0, "MM", "Depth of a roughing cut, on the radius (default 1.5)"},
          {"allowance", 0, "MM", "Allowance for finishing (default 0.3)"},
          {"nose", 0, "MM", "Nose radius of the tools of cycles (default 0.4)"},
          {"rough-feed", 0, "MM", "Feed of roughing, per revolution (default 0.25)"},
          {"finish-feed", 0, "MM", "Feed of finishing, per revolution (default 0.08)"},
          {"speed", 0, "M/MIN", "Surface speed in cycles (default 150)"},
          {"max-rpm", 0, "RPM", "Largest speed of the spindle in cycles (default 2000)"},
          {"drill", 0, "MM|auto", "Also make the bore, through or blind, from a hole of this diameter"},
          {"facing", 0, "MM", "How far the bar stands over the face of the target, which is faced (default 0)"},
          {"write-tools", 0, "P.tbl",
           "Also write the tools of the program, for turn --tools; Q in the numbers of the dialect"},
          {"spindle", 0, "RPM", "Speed of the spindle for recorded passes (default: their mean)"},
          {"help", 'h', "", "Show this help"},
      },
      "FROM -o P.ngc [--dialect NAME] [--post SIDE] [--stock cylinder:DxL [--depth MM] [--nose MM] ...]"};
  for (OptionSpec& option : postOptions()) spec.options.push_back(std::move(option));
  return {std::move(spec), runProgramCommand};
}

}  // namespace handwheel
