// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/TrainCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationJson.h"
#include "cli/OperationOptions.h"
#include "cli/ReportJson.h"
#include "document/AtomicFile.h"
#include "document/FileBytes.h"
#include "machining/force/ForceCsv.h"
#include "machining/force/ForceErrors.h"
#include "machining/force/training/ForceTraining.h"
#include "plot/PlotExport.h"
#include "tools/workpiece/ForceOperations.h"

#include <QFile>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::string_view kSynthetic = "synthetic:";
constexpr std::size_t kMostTableBytes = 64 << 20;
constexpr QSize kCurveSize(640, 440);

struct TrainRequest {
  std::vector<std::string> inputs;
  std::filesystem::path output, plot;
  OperationValues values{trainOperation()};
};

// Reads the arguments. Returns a problem, or an empty string.
std::string readRequest(const Arguments& arguments, const DocumentKinds& kinds, TrainRequest& request) {
  if (!arguments.has("output")) return "The option -o MODEL.json is missing.";
  request.inputs = arguments.operands;
  request.output = arguments.valueOf("output");
  request.plot = arguments.valueOf("plot");
  if (const std::string problem = readOptions(arguments, request.values); !problem.empty()) return problem;
  if (isDocumentName(request.output, kinds)) return "-o takes a name such as model.json, not that of a document.";
  for (const std::string& input : request.inputs) {
    if (isSameFile(input, request.output)) return "The model would replace the table " + input + ".";
    if (input.starts_with(kSynthetic) && request.inputs.size() > 1)
      return "Calculated rows are not mixed with others: give " + input + " alone.";
  }
  const std::string extension = request.plot.extension().string();
  if (arguments.has("plot") && extension != ".png" && extension != ".svg" && extension != ".csv")
    return "--plot takes a name that ends in .png, .svg or .csv.";
  return {};
}

Error about(Error error, const std::string& subject) {
  error.subject = subject;
  return error;
}

Result<ForceSamples> synthetic(const std::string& id) {
  const WorkMaterials& materials = WorkMaterials::standard();
  if (const WorkMaterial* material = materials.find(id)) return syntheticSamples(*material, KosilovaTables::standard());
  return Error{ForceErrors::MaterialUnknown, {id}, {}, {}};
}

// All tables as one.
Result<ForceSamples> readTables(const TrainRequest& request, Progress progress) {
  const std::string& first = request.inputs[0];
  if (first.starts_with(kSynthetic)) return synthetic(first.substr(kSynthetic.size()));
  ForceSamples all;
  all.origin = "Measured:";
  for (const std::string& path : request.inputs) {
    const Result<std::string> text = readFileHead(path, kMostTableBytes + 1);
    if (!text) return about(text.error(), path);
    if (text->size() > kMostTableBytes)
      return Error{ErrorCode::FileTooLarge, {"bytes", {}, std::to_string(kMostTableBytes)}, {}, path};
    const auto table = forceSamplesFromCsv(*text, request.values.given("diameter").value_or(0.0), progress);
    if (!table) return about(table.error(), path);
    all.samples.insert(all.samples.end(), table->samples.begin(), table->samples.end());
    all.origin += " " + std::filesystem::path(path).filename().string();
    all.rows += table->rows;
    all.wornRows += table->wornRows;
    all.gapRows += table->gapRows;
  }
  return all;
}

Plot curveOf(const ForceTraining& training, const TrainRequest& request) {
  Plot plot;
  plot.title = "Training by " + QString::fromStdString(training.model.origin().trainer);
  plot.x = {"epoch", {}, false};
  plot.y = {"mean squared error", {}, true};
  PlotSeries series{"error", {}, true};
  series.dotted = training.errors.size() <= 100;
  for (std::size_t i = 0; i < training.errors.size(); ++i)
    series.points.emplace_back(static_cast<double>(i), training.errors[i]);
  plot.series.push_back(std::move(series));
  if (const double goal = request.values.number("goal"); goal > 0.0)
    plot.series.push_back(
        {"goal", {{0.0, goal}, {static_cast<double>(training.epochs()), goal}}, true, 0.0, {}, false});
  return plot;
}

nlohmann::ordered_json toJson(const HeldOutErrors& errors) {
  return {{"cuts", errors.cuts}, {"mean", errors.mean}, {"median", errors.median}, {"worst", errors.worst}};
}

std::string jsonReport(const ForceSamples& samples, const ForceTraining& training, const TrainRequest& request) {
  const PowerLaw& law = training.model.powerLaw();
  const ForceNetwork& network = training.model.network();
  return textOf({
      {"options", toJson(request.values)},
      {"data", samples.origin},
      {"synthetic", samples.isSynthetic},
      {"rows", samples.rows},
      {"rows_worn", samples.wornRows},
      {"rows_incomplete", samples.gapRows},
      {"cuts", samples.samples.size()},
      {"conditions", training.conditions},
      {"epochs", training.epochs()},
      {"mse", training.model.origin().error},
      {"goal_reached", training.isGoalReached},
      {"cpu_ms", training.seconds * 1e3},
      {"errors", training.errors},
      {"held_out", {{"network", toJson(training.network)}, {"power_law", toJson(training.powerLaw)}}},
      {"power_law", {{"C", std::exp(law.logC)}, {"x", law.x}, {"y", law.y}, {"n", law.n}}},
      {"range",
       {{"depth_mm", {network.least[0], network.largest[0]}},
        {"feed_mm_per_rev", {network.least[1], network.largest[1]}},
        {"speed_m_per_min", {network.least[2], network.largest[2]}},
        {"force_N", {network.leastForce, network.largestForce}}}},
  });
}

std::string percent(double share) {
  return roundedText(100.0 * share, 3) + " %";
}

std::string rangeText(const ForceNetwork& network, std::size_t i) {
  return roundedText(network.least[i], 4) + " to " + roundedText(network.largest[i], 4);
}

std::string readableReport(const ForceSamples& samples, const ForceTraining& training) {
  const PowerLaw& law = training.model.powerLaw();
  const ForceNetwork& network = training.model.network();
  std::string text = samples.origin + ".\n";
  if (samples.isSynthetic) text += "These rows are calculated from tables, not measured.\n";
  text += "Rows: " + std::to_string(samples.rows) + ", different cuts: " + std::to_string(samples.samples.size()) +
          " at " + std::to_string(training.conditions) + " conditions.\n";
  if (samples.wornRows > 0) text += "Left out, worn tool: " + std::to_string(samples.wornRows) + " rows.\n";
  if (samples.gapRows > 0) text += "Left out, values missing: " + std::to_string(samples.gapRows) + " rows.\n";
  text += "Epochs: " + std::to_string(training.epochs()) + " in " + roundedText(training.seconds * 1e3, 3) +
          " ms. Mean squared error: " + roundedText(training.model.origin().error, 3) +
          (training.isGoalReached ? ", the goal is reached.\n" : ", the goal is not reached.\n");
  text += "Held out: " + std::to_string(training.network.cuts) + " cuts, mean error " + percent(training.network.mean) +
          ", median " + percent(training.network.median) + "; the power law " + percent(training.powerLaw.mean) +
          ", median " + percent(training.powerLaw.median) + ".\n";
  text += "Power law: Fc = " + roundedText(std::exp(law.logC), 4) + " d^" + roundedText(law.x, 3) + " f^" +
          roundedText(law.y, 3) + " v^" + roundedText(law.n, 3) + " N.\n";
  text += "Range: depth " + rangeText(network, 0) + " mm, feed " + rangeText(network, 1) + " mm, speed " +
          rangeText(network, 2) + " m/min. Outside, the power law is used.\n";
  return text;
}

struct Trained {
  ForceSamples samples;
  ForceTraining training;
};

Result<Trained> train(const TrainRequest& request, Progress progress) {
  Result<ForceSamples> samples = readTables(request, progress.part(0.0, 0.1));
  if (!samples) return samples.error();
  const std::string& input = request.inputs[0];
  const std::string material = samples->isSynthetic ? input.substr(kSynthetic.size()) : std::string();
  Result<ForceTraining> training =
      trainForceModel(*samples, trainingOptionsOf(request.values), material, progress.part(0.1, 1.0));
  if (!training) return about(training.error(), input);
  return Trained{std::move(samples.value()), std::move(training.value())};
}

int runTrain(const Arguments& arguments, const DocumentKinds& kinds) {
  TrainRequest request;
  if (const std::string problem = readRequest(arguments, kinds, request); !problem.empty())
    return failUsage(problem, "train");
  std::optional<Result<Trained>> trained;
  runInterruptible("Training", [&](CommandJob& job) { trained = train(request, job.progress()); });
  if (!*trained) return fail(trained->error());
  const ForceTraining& training = trained->value().training;
  ignoreSignals();
  if (const Status written = writeFileAtomically(request.output, toJson(training.model)); !written)
    return fail(about(written.error(), request.output.string()));
  if (!request.plot.empty()) {
    const Plot curve = curveOf(training, request);
    const Status drawn =
        exportPlots({&curve, 1}, QFile::decodeName(request.plot.c_str()), kCurveSize, ThemeKind::Light);
    if (!drawn) return fail(about(drawn.error(), request.plot.string()));
  }
  const ForceSamples& samples = trained->value().samples;
  const int code =
      print(arguments.has("json") ? jsonReport(samples, training, request) : readableReport(samples, training));
  return code == kExitDone && !training.isGoalReached && request.values.number("goal") > 0.0 ? kExitSomethingLeft
                                                                                             : code;
}

}  // namespace

Command trainCommand() {
  CommandSpec spec = {
      trainOperation().id,
      "DATA [MORE...]",
      "Trains a model of cutting forces on measured cuts: a neural network of depth, feed and speed, with a power law\n"
      "outside of the measured range. DATA is a table with a header line: ap (mm), f (mm), v (m/min), Fc (N), or with\n"
      "the columns ap,vc,f,Fx or rpm,f_cal,A_cal,Fz of published measurements; rows of a worn tool are left out.\n"
      "synthetic:MATERIAL stands for rows calculated from the cited tables ('handwheel force --list').\n"
      "To judge the model, each fifth of the conditions is held out once; then it is trained on all.\n"
      "Exit code 0: done; 2: the goal was not reached, and the best model is written; 1: error.",
      {}};
  spec.options = optionsOf(trainOperation());
  spec.options.push_back({"output", 'o', "MODEL.json", "The model to write"});
  spec.options.push_back({"plot", 0, "FILE", "Draw the error by epoch, as .png or .svg, or write it as .csv"});
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  Command command{std::move(spec), runTrain};
  command.needsFonts = [](std::span<char* const> words) {
    return std::any_of(words.begin(), words.end(),
                       [](std::string_view word) { return word == "--plot" || word.starts_with("--plot="); });
  };
  return command;
}

}  // namespace handwheel
