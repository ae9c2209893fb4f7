// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/volume/DrillExperimentCommand.h"

#include "base/NumberText.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/commands/MeasureReport.h"
#include "plot/PlotExport.h"
#include "volume/drilling/DrillExperiments.h"

#include <QFile>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string_view>

namespace handwheel {
namespace {

using Results = std::vector<DrillExperimentResult>;

constexpr QSize kExperimentPlotSize(560, 420);

struct ExperimentWords {
  const char *title, *value, *unit;  // texts of the table and of an axis
};

ExperimentWords wordsOf(DrillExperiment experiment) {
  switch (experiment) {
    case DrillExperiment::Resolution:
      return {"Resolution (figure 3-38)", "Voxel", "mm"};
    case DrillExperiment::Erosion:
      return {"Erosion (figure 3-40)", "Step", "of 255 levels"};
    case DrillExperiment::Radius:
      return {"Radius (figures 3-41 and 3-42)", "Radius", "mm"};
    case DrillExperiment::Feed:
      return {"Feed (figures 3-41 and 3-42)", "Feed", "mm/s"};
  }
  return {};
}

const char* sentenceOf(DrillShapeCheck::Kind kind) {
  using Kind = DrillShapeCheck::Kind;
  switch (kind) {
    case Kind::SteppedRippleByVoxel:
      return "He's ripple grows with the voxel; least growth";
    case Kind::SteppedRippleAtRule:
      return "He's ripple with the voxel of the rule (3-20)";
    case Kind::OurRippleByVoxel:
      return "our ripple grows with the voxel; least growth";
    case Kind::BuildUp:
      return "our thrust grows nearly linearly while the ball goes in; correlation";
    case Kind::SteppedRippleByErosion:
      return "He's ripple grows with the step; least growth";
    case Kind::SteppedRippleAtFour:
      return "He's ripple at steps of 4/255 is a tenth or more";
    case Kind::OurRippleByErosion:
      return "our ripple is below a tenth at any step; the largest";
    case Kind::ThrustByRadius:
      return "thrust is linear in the radius; power";
    case Kind::TorqueByRadius:
      return "torque is quadratic in the radius; power";
    case Kind::ThrustByFeed:
      return "thrust is linear in the feed below 6 mm/s; power";
    case Kind::TorqueByFeed:
      return "torque is linear in the feed below 6 mm/s; power";
    case Kind::SteppedThrustAboveSix:
      return "He's thrust at 10 mm/s stays behind the line; share of it";
  }
  return "";
}

std::string readableText(const DrillExperimentResult& result) {
  const ExperimentWords words = wordsOf(result.experiment);
  std::vector<TableRow> rows{{std::string(words.value) + " " + words.unit, "thrust N", "torque N·mm", "ripple %",
                              "He: thrust N", "ripple %", "balance: N", "N·mm", "(3-22) N", "(3-23) N·mm"}};
  for (const DrillExperimentHole& hole : result.holes) {
    TableRow row;
    for (const double x : {hole.value, hole.ours.mean.thrust, hole.ours.mean.torque, 100.0 * hole.ours.ripple,
                           hole.stepped.mean.thrust, 100.0 * hole.stepped.ripple, hole.balance.thrust,
                           hole.balance.torque, hole.reference.thrust, hole.reference.torque})
      row.push_back(roundedText(x, 4));
    rows.push_back(std::move(row));
  }
  std::string text = std::string(words.title) + "\n" + alignedTable(rows);
  for (const DrillShapeCheck& check : shapeChecksOf(result))
    text += std::string(check.holds() ? "  as stated: " : "  not as stated: ") + sentenceOf(check.kind) + " " +
            roundedText(check.found, 3) + ".\n";
  return text;
}

nlohmann::ordered_json evenJson(const EvenLoad& load) {
  return {{"thrust_N", load.mean.thrust}, {"torque_Nmm", load.mean.torque}, {"ripple", load.ripple}};
}

nlohmann::ordered_json loadJson(const DrillLoad& load) {
  return {{"thrust_N", load.thrust}, {"torque_Nmm", load.torque}};
}

nlohmann::ordered_json jsonOf(const Results& results) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const DrillExperimentResult& result : results) {
    nlohmann::ordered_json holes = nlohmann::ordered_json::array(), checks = nlohmann::ordered_json::array();
    for (const DrillExperimentHole& hole : result.holes)
      holes.push_back({{"value", hole.value},
                       {"handwheel", evenJson(hole.ours)},
                       {"he_2008", evenJson(hole.stepped)},
                       {"balance", loadJson(hole.balance)},
                       {"reference", loadJson(hole.reference)}});
    for (const DrillShapeCheck& check : shapeChecksOf(result))
      checks.push_back({{"shape", sentenceOf(check.kind)}, {"found", check.found}, {"holds", check.holds()}});
    all.push_back({{"experiment", idOf(result.experiment)},
                   {"unit", wordsOf(result.experiment).unit},
                   {"holes", holes},
                   {"checks", checks}});
  }
  return {{"experiments", all}};
}

// Thrust over time of all holes in sequence. Cycles are thinned to the resolution of the plot.
Plot curvePlot(const DrillExperimentResult& result, const QString& title, bool isOurs) {
  constexpr std::size_t kCyclesPerPoint = 20;
  Plot plot;
  plot.title = title;
  plot.x = {QStringLiteral("Time"), QStringLiteral("s")};
  plot.y = {QStringLiteral("Thrust"), QStringLiteral("N")};
  const ExperimentWords words = wordsOf(result.experiment);
  for (const DrillExperimentHole& hole : result.holes) {
    PlotSeries series;
    series.name = QString::fromUtf8(words.value) + ' ' + QString::fromStdString(roundedText(hole.value));
    series.dotted = false;
    const std::vector<float>& thrust = isOurs ? hole.ourThrust : hole.itsThrust;
    for (std::size_t i = 0; i < thrust.size(); i += kCyclesPerPoint)
      series.points.emplace_back(static_cast<double>(i) / result.rate, static_cast<double>(thrust[i]));
    plot.series.push_back(std::move(series));
  }
  return plot;
}

template <class Figure>
PlotSeries seriesOf(const char* name, const std::vector<DrillExperimentHole>& holes, Figure figure) {
  PlotSeries series;
  series.name = QString::fromUtf8(name);
  for (const DrillExperimentHole& hole : holes) series.points.emplace_back(hole.value, figure(hole));
  return series;
}

std::vector<Plot> plotsOf(const Results& results) {
  using Hole = DrillExperimentHole;
  std::vector<Plot> plots;
  for (const DrillExperimentResult& result : results) {
    const ExperimentWords words = wordsOf(result.experiment);
    const QString title = QString::fromUtf8(words.title);
    Plot thrust;
    thrust.title = title;
    thrust.x = {QString::fromUtf8(words.value), QString::fromUtf8(words.unit)};
    thrust.y = {QStringLiteral("Thrust"), QStringLiteral("N")};
    Plot torque = thrust;
    torque.y = {QStringLiteral("Torque"), QStringLiteral("N·mm")};
    thrust.series = {seriesOf("Handwheel", result.holes, [](const Hole& h) { return h.ours.mean.thrust; }),
                     seriesOf("He 2008", result.holes, [](const Hole& h) { return h.stepped.mean.thrust; }),
                     seriesOf("Balance of energy", result.holes, [](const Hole& h) { return h.balance.thrust; }),
                     seriesOf("(3-22)", result.holes, [](const Hole& h) { return h.reference.thrust; })};
    torque.series = {seriesOf("Handwheel", result.holes, [](const Hole& h) { return h.ours.mean.torque; }),
                     seriesOf("He 2008", result.holes, [](const Hole& h) { return h.stepped.mean.torque; }),
                     seriesOf("Balance of energy", result.holes, [](const Hole& h) { return h.balance.torque; }),
                     seriesOf("(3-23)", result.holes, [](const Hole& h) { return h.reference.torque; })};
    plots.push_back(std::move(thrust));
    plots.push_back(std::move(torque));
    plots.push_back(curvePlot(result, title + QStringLiteral(", Handwheel"), true));
    plots.push_back(curvePlot(result, title + QStringLiteral(", He 2008"), false));
  }
  return plots;
}

CommandSpec experimentSpec() {
  return {"drill-experiments",
          "[NAME...]",
          "Repeats the reference runs of drilling, and checks the stated shapes of their curves.\n"
          "NAME is resolution, erosion, radius or feed (He 2008, 3.3); default: all. A ball of 6 mm goes through a "
          "plate of cortical\nbone at 1 mm/s and 1 kHz, in voxels of 0.255 mm. Beside our thrust and torque are those "
          "of He's erosion in steps, those\nof the balance of energy, and (3-22) and (3-23).\n"
          "Exit code 0: done; 2: a shape is not as stated; 1: error.",
          {{"values", 0, "LIST", "Of one NAME: other values than those of the thesis, as 0.255,0.51"},
           {"plot", 0, "FILE", "Plot the curves, as .png or .svg, or write their points as .csv"},
           {"dark", 0, "", "Draw on a dark background"},
           {"json", 0, "", "Print everything as JSON"},
           {"help", 'h', "", "Show this help"}}};
}

// Returns the values of a list, in ascending order; none if one is not valid for the experiment.
std::optional<std::vector<double>> readValues(std::string_view list, DrillExperiment experiment) {
  constexpr std::size_t kMostValues = 100;
  std::set<double> values;
  while (true) {
    const std::size_t comma = list.find(',');
    double value = 0.0;
    if (!readNumber(list.substr(0, comma), value) || !isDrillable(experiment, value)) return std::nullopt;
    values.insert(value);
    if (comma == std::string_view::npos) break;
    list.remove_prefix(comma + 1);
  }
  if (values.size() > kMostValues) return std::nullopt;
  return std::vector<double>(values.begin(), values.end());
}

bool plotsExperiments(std::span<char* const> words) {
  return std::any_of(words.begin(), words.end(), [](std::string_view word) { return word.starts_with("--plot"); });
}

int runExperiments(const Arguments& arguments, const DocumentKinds&) {
  std::vector<DrillExperiment> chosen;
  for (const std::string& name : arguments.operands) {
    const auto experiment = drillExperimentOf(name);
    if (!experiment)
      return failUsage("There is no experiment " + name + "; choose resolution, erosion, radius or feed.",
                       "drill-experiments");
    if (std::find(chosen.begin(), chosen.end(), *experiment) == chosen.end()) chosen.push_back(*experiment);
  }
  std::optional<std::vector<double>> values;
  if (arguments.has("values")) {
    if (chosen.size() != 1) return failUsage("--values belongs to one experiment; name it.", "drill-experiments");
    values = readValues(arguments.valueOf("values"), chosen.front());
    if (!values)
      return failUsage("--values takes up to 100 numbers above zero that a hole can have, as 0.255,0.51.",
                       "drill-experiments");
  }
  if (chosen.empty()) chosen.assign(kDrillExperiments.begin(), kDrillExperiments.end());
  const std::string ending = std::filesystem::path(arguments.valueOf("plot")).extension().string();
  if (arguments.has("plot") && ending != ".png" && ending != ".svg" && ending != ".csv")
    return failUsage("--plot takes a name that ends in .png, .svg or .csv.", "drill-experiments");

  Results results;
  std::optional<Error> problem;
  runInterruptible("Drilling", [&](CommandJob& job) {
    const auto count = static_cast<double>(chosen.size());
    for (const DrillExperiment experiment : chosen) {
      const auto at = static_cast<double>(results.size());
      Result<DrillExperimentResult> result = runDrillExperiment(experiment, values.value_or(valuesOf(experiment)),
                                                                job.progress().part(at / count, (at + 1.0) / count));
      if (!result) {
        problem = result.error();
        return;
      }
      results.push_back(std::move(*result));
    }
  });
  if (problem) return fail(*problem);
  if (arguments.has("plot")) {
    const Status written = exportPlots(plotsOf(results), QFile::decodeName(arguments.valueOf("plot").c_str()),
                                       kExperimentPlotSize, arguments.has("dark") ? ThemeKind::Dark : ThemeKind::Light);
    if (!written) return fail(written.error());
  }
  std::string text;
  for (const DrillExperimentResult& result : results) text += (text.empty() ? "" : "\n") + readableText(result);
  const int code = print(arguments.has("json") ? jsonOf(results).dump() + "\n" : text);
  if (code != kExitDone) return code;
  for (const DrillExperimentResult& result : results)
    for (const DrillShapeCheck& check : shapeChecksOf(result))
      if (!check.holds()) return kExitSomethingLeft;
  return kExitDone;
}

}  // namespace

Command drillExperimentCommand() {
  return {experimentSpec(), runExperiments, nullptr, plotsExperiments};
}

}  // namespace handwheel
