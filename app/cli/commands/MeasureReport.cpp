// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/MeasureReport.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::ordered_json;

std::string number(double value) {
  return std::isinf(value) ? "no result" : roundedText(value, 3);
}

// Returns the row of the same case at the default.
const FidelityRow& standardRow(const MeasuredSetting& m, const FidelityRow& row) {
  const auto at = std::find_if(m.rows.begin(), m.rows.end(), [&](const FidelityRow& r) {
    return r.testCase == row.testCase && r.value == m.setting.standard;
  });
  assert(at != m.rows.end());  // a sweep always takes the default
  return *at;
}

// Returns "x 2.5": the multiple of the default.
std::string ratio(double value, double standard) {
  if (std::isinf(value) || std::isinf(standard)) return "-";
  if (value == standard) return "x 1";
  return standard == 0.0 ? "-" : "x " + number(value / standard);
}

std::string withFigures(const MeasuredSetting& m, double value) {
  const CurvePoint& p = m.at(value);
  return textOf(m.setting, value) + " (" + number(p.error) + " " + m.setting.error.unit + ", " + number(p.cost) + " " +
         m.setting.cost.unit + ")";
}

std::string measurements(const MeasuredSetting& m) {
  std::vector<TableRow> rows{{"value", "case", "error", "/ default", "cost", "/ default", "spread", "truth"}};
  for (const FidelityRow& r : m.rows) {
    const FidelityRow& standard = standardRow(m, r);
    rows.push_back({textOf(m.setting, r.value), r.testCase, number(r.error), ratio(r.error, standard.error),
                    number(r.cost), ratio(r.cost, standard.cost), number(r.spread), r.truth});
  }
  return alignedTable(rows);
}

std::optional<double> budgetOf(const MeasuredSetting& m, const FidelityBudgets& budgets) {
  const auto at = budgets.find(m.setting.cost.unit);
  return at == budgets.end() ? std::nullopt : std::optional(at->second);
}

Json pointJson(const MeasuredSetting& m, double value) {
  const CurvePoint& p = m.at(value);
  return {{"value", textOf(m.setting, value)},
          {"error", std::isfinite(p.error) ? Json(p.error) : Json(nullptr)},
          {"cost", p.cost}};
}

Json rowJson(const MeasuredSetting& m, const FidelityRow& r) {
  const FidelityRow& standard = standardRow(m, r);
  return {{"value", textOf(m.setting, r.value)},
          {"case", r.testCase},
          {"error", std::isfinite(r.error) ? Json(r.error) : Json(nullptr)},
          {"cost", r.cost},
          {"cost_of_default", standard.cost > 0.0 ? Json(r.cost / standard.cost) : Json(nullptr)},
          {"spread", r.spread},
          {"repeats", r.repeats},
          {"seed", r.seed},
          {"truth", r.truth}};
}

}  // namespace

MeasuredSetting::MeasuredSetting(const FidelitySetting& of, std::vector<FidelityRow> measured)
    : setting(of), rows(std::move(measured)), curve(curveOf(rows)), front(paretoFront(relativeCurveOf(of, rows))) {
  if (const auto index = kneeOf(front)) knee = front[*index].value;
}

const CurvePoint& MeasuredSetting::at(double value) const {
  const auto found = std::find_if(curve.begin(), curve.end(), [&](const CurvePoint& p) { return p.value == value; });
  assert(found != curve.end());
  return *found;
}

std::string alignedTable(const std::vector<TableRow>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const TableRow& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const TableRow& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string blanks(widths[i] - row[i].size(), ' ');
      text += "  " + (i < 2 ? row[i] + blanks : blanks + row[i]);
    }
    text += "\n";
  }
  return text;
}

std::string readableText(const MeasuredSetting& m, const FidelityBudgets& budgets) {
  const FidelitySetting& s = m.setting;
  std::string text = s.id + ": " + s.label + (s.unit.empty() ? "" : " (" + s.unit + ")") + "\n";
  text += "  Error: " + s.error.name + " (" + s.error.unit + "). Cost: " + s.cost.name + " (" + s.cost.unit + ").\n";
  text += measurements(m);
  text += "  Front, in multiples of the default in the worst case:";
  for (const CurvePoint& p : m.front) text += (p == m.front.front() ? " " : ", ") + textOf(s, p.value);
  text += "; knee: " + (m.knee ? textOf(s, *m.knee) : std::string("none")) + "\n";
  for (FidelityPreset preset : kFidelityPresets) {
    text += "  " + std::string(wordFor(preset)) + ": " + withFigures(m, s.presetValue(preset)) + "\n";
  }
  text += "  Default: " + withFigures(m, s.standard) + "\n";
  if (const auto budget = budgetOf(m, budgets)) {
    const auto fit = fitToBudget(m.curve, *budget);
    text +=
        "  Fit for " + number(*budget) + " " + s.cost.unit + ": " + (fit ? withFigures(m, fit->value) : "none") + "\n";
  }
  return text;
}

Json toJson(const MeasuredSetting& m, const FidelityBudgets& budgets) {
  const FidelitySetting& s = m.setting;
  Json json{{"setting", s.id},
            {"label", s.label},
            {"unit", s.unit},
            {"error", {{"name", s.error.name}, {"unit", s.error.unit}}},
            {"cost", {{"name", s.cost.name}, {"unit", s.cost.unit}}},
            {"rows", Json::array()},
            {"front", Json::array()},
            {"knee", m.knee ? Json(textOf(s, *m.knee)) : Json(nullptr)}};
  for (const FidelityRow& r : m.rows) json["rows"].push_back(rowJson(m, r));
  for (const CurvePoint& p : m.front) json["front"].push_back(textOf(s, p.value));
  for (FidelityPreset preset : kFidelityPresets) {
    json["presets"][std::string(wordFor(preset))] = pointJson(m, s.presetValue(preset));
  }
  json["default"] = pointJson(m, s.standard);
  if (const auto budget = budgetOf(m, budgets)) {
    const auto fit = fitToBudget(m.curve, *budget);
    json["fit"] = fit ? pointJson(m, fit->value) : Json(nullptr);
  }
  return json;
}

Plot plotOf(const MeasuredSetting& m) {
  const FidelitySetting& s = m.setting;
  Plot plot;
  plot.title = QString::fromStdString(s.id);
  plot.x = {QString::fromStdString(s.cost.name), QString::fromStdString(s.cost.unit), true};
  plot.y = {QString::fromStdString(s.error.name), QString::fromStdString(s.error.unit), true};
  for (const FidelityRow& r : m.rows) {
    const QString name = QString::fromStdString(r.testCase);
    if (plot.series.empty() || plot.series.back().name != name) plot.series.push_back({name, {}, true});
    plot.series.back().points.emplace_back(r.cost, r.error);
  }
  std::map<double, QString> words;  // by value: presets that coincide share a mark
  for (FidelityPreset preset : kFidelityPresets) {
    QString& word = words[s.presetValue(preset)];
    word += (word.isEmpty() ? "" : ", ") + QString::fromStdString(std::string(wordFor(preset)));
  }
  words[s.standard] += words[s.standard].isEmpty() ? "default" : ", default";
  for (const auto& [value, word] : words) {
    const FidelityRow& row = *std::max_element(m.rows.begin(), m.rows.end(), [v = value](const auto& a, const auto& b) {
      return std::pair(a.value == v, a.cost) < std::pair(b.value == v, b.cost);
    });
    plot.marks.push_back({{row.cost, row.error}, word});
  }
  return plot;
}

}  // namespace handwheel
