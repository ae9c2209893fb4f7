// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/exercise/MarkingReport.h"

#include "base/NumberText.h"
#include "document/AtomicFile.h"
#include "document/DocumentKind.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/Submission.h"
#include "plot/PlotExport.h"

#include <QBuffer>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kPlotWidth = 640, kPlotHeight = 300;  // in pixels at 96 a inch
constexpr double kSharpness = 2.0;                  // of the plots on paper

// Makes the element of an image.
using ImageElement = std::function<std::string(const QImage&, const std::string& name)>;

std::string escaped(const std::string& text) {
  return QString::fromStdString(text).toHtmlEscaped().toStdString();
}

std::string verdictWord(Verdict verdict) {
  switch (verdict) {
    case Verdict::Met:
      return "met";
    case Verdict::TooSmall:
      return "too small";
    case Verdict::TooLarge:
      return "too large";
    case Verdict::NotMeasured:
      break;
  }
  return "not measured";
}

std::string unitOf(const ClassReport& report, const MarkingCriterion& c) {
  const FigureType* type = figureType(report.figures, c.figure);
  return type ? type->unit : std::string();
}

std::string limitsOf(const MarkingCriterion& c) {
  if (c.lower && c.upper) return roundedText(*c.lower) + " … " + roundedText(*c.upper);
  if (c.upper) return "≤ " + roundedText(*c.upper);
  return c.lower ? "≥ " + roundedText(*c.lower) : std::string();
}

std::string minutesText(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  const std::string rest = std::to_string(whole % 60);
  return std::to_string(whole / 60) + ":" + (rest.size() < 2 ? "0" : "") + rest + " min";
}

std::string pointsText(const Marking& marking) {
  return roundedText(marking.points) + " of " + roundedText(marking.of) + " points";
}

// The marks of one student as cells: criterion, limits, measured, points, reason.
std::vector<std::array<std::string, 5>> rowsOf(const ClassReport& report, const Marking& marking) {
  std::vector<std::array<std::string, 5>> rows;
  for (const Mark& mark : marking.marks) {
    const MarkingCriterion* c = report.exercise.find(mark.criterion);
    if (!c) continue;
    const std::string unit = unitOf(report, *c);
    const std::string remark = mark.remark.inEnglish();
    rows.push_back({c->name, limitsOf(*c) + (unit.empty() ? "" : " " + unit),
                    mark.value ? roundedText(*mark.value) : "–",
                    roundedText(mark.points) + " / " + roundedText(mark.of),
                    mark.reason.inEnglish() + (remark.empty() ? "" : " (" + remark + ")")});
  }
  return rows;
}

Plot plotOf(const ReportCurve& curve) {
  Plot plot;
  plot.title = QString::fromStdString(curve.title);
  plot.x = {QString::fromStdString(curve.x), QString::fromStdString(curve.xUnit)};
  plot.y = {QString::fromStdString(curve.y), QString::fromStdString(curve.yUnit)};
  for (const ReportCurve::Series& each : curve.series) {
    PlotSeries series;
    series.name = QString::fromStdString(each.name);
    series.dotted = false;
    for (const auto& [x, y] : each.points) series.points.emplace_back(x, y);
    plot.series.push_back(std::move(series));
  }
  return plot;
}

std::string classTable(const ClassReport& report) {
  ClassTable table(report.exercise);
  for (const ReportedWork& work : report.works) table.add(work.row);
  std::string html = "<table border=\"1\" cellspacing=\"0\" cellpadding=\"4\">\n<tr>";
  for (std::size_t column = 0; column < table.columns(); ++column)
    html += "<th>" + escaped(table.heading(column)) + "</th>";
  html += "</tr>\n";
  for (std::size_t row = 0; row < table.rows().size(); ++row) {
    html += "<tr>";
    for (std::size_t column = 0; column < table.columns(); ++column)
      html += "<td>" + escaped(table.cell(row, column)) + "</td>";
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string workSection(const ClassReport& report, const ReportedWork& work, const std::string& name,
                        const ImageElement& image) {
  const ClassRow& row = work.row;
  const std::string heading = row.attempt.student.empty() ? row.file : row.attempt.student;
  std::string html = "<h2>" + escaped(heading) + "</h2>\n<p>File: " + escaped(row.file);
  if (row.attempt.isHandedIn()) html += "<br/>Handed in: " + escaped(row.attempt.handedIn);
  html += "</p>\n";
  if (!row.problem.empty()) return html + "<p><b>Not marked: " + escaped(row.problem) + "</b></p>\n";
  html += "<p><b>" + pointsText(row.marking) + "</b><br/>Time: " + minutesText(row.attempt.seconds) + ", of it " +
          minutesText(work.details.seconds) + " cutting. Hints looked at: " + std::to_string(row.attempt.hintCount()) +
          ".</p>\n<table border=\"1\" cellspacing=\"0\" cellpadding=\"4\">\n"
          "<tr><th>Criterion</th><th>Limits</th><th>Measured</th><th>Points</th><th>Reason</th></tr>\n";
  for (const auto& cells : rowsOf(report, row.marking)) {
    html += "<tr>";
    for (const std::string& cell : cells) html += "<td>" + escaped(cell) + "</td>";
    html += "</tr>\n";
  }
  html += "</table>\n";
  if (!work.details.events.empty()) {
    html += "<h3>Collisions</h3>\n<ul>\n";
    for (const ReportEvent& event : work.details.events)
      html += "<li>" + minutesText(event.seconds) + ": " + escaped(event.text.inEnglish()) + "</li>\n";
    html += "</ul>\n";
  }
  if (!work.picture.isNull()) html += "<p>" + image(work.picture, name + "-picture") + "</p>\n";
  for (std::size_t i = 0; i < work.details.curves.size(); ++i) {
    const Plot plot = plotOf(work.details.curves[i]);
    const QImage drawn = plotImage({&plot, 1}, {kPlotWidth, kPlotHeight}, ThemeKind::Light, kSharpness);
    html += "<p>" + image(drawn, name + "-" + std::to_string(i)) + "</p>\n";
  }
  return html;
}

std::string bodyOf(const ClassReport& report, const ImageElement& image) {
  std::string html = "<h1>" + escaped(report.exercise.title) + "</h1>\n";
  if (!report.exercise.text.empty()) html += "<p>" + escaped(report.exercise.text) + "</p>\n";
  if (report.works.size() > 1) html += classTable(report);
  for (std::size_t i = 0; i < report.works.size(); ++i)
    html += workSection(report, report.works[i], "work" + std::to_string(i), image);
  return html;
}

std::string base64Png(const QImage& picture) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  picture.save(&buffer, "PNG");
  return buffer.data().toBase64().toStdString();
}

Json numberOrNull(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json jsonOf(const ClassReport& report, const Mark& mark) {
  const MarkingCriterion& c = *report.exercise.find(mark.criterion);
  return {{"id", c.id},
          {"name", c.name},
          {"figure", c.figure},
          {"unit", unitOf(report, c)},
          {"lower", numberOrNull(c.lower)},
          {"upper", numberOrNull(c.upper)},
          {"measured", numberOrNull(mark.value)},
          {"verdict", verdictWord(mark.verdict)},
          {"points", mark.points},
          {"of", mark.of},
          {"reason", mark.reason.inEnglish()},
          {"remark", mark.remark.inEnglish()}};
}

}  // namespace

ReportedWork markFile(const ExerciseSnapshot& scheme, const std::filesystem::path& path, const DocumentKinds& kinds,
                      std::string (*describe)(const Error&), Progress progress) {
  ReportedWork work;
  work.row.file = path.filename().string();
  const Result<OpenedFile> opened = kinds.open(path, {}, progress.part(0.0, 0.3));
  const auto submission = opened ? std::dynamic_pointer_cast<const ExerciseSnapshot>(opened->content) : nullptr;
  const auto marked = [&]() -> Result<ClassRow> {
    if (!opened) return opened.error();
    if (!submission) return Error{ExerciseError::NotHandedIn, {}, {}, {}};
    return markSubmission(scheme, *submission, work.row.file, progress.part(0.3, 0.7));
  };
  if (Result<ClassRow> row = marked()) {
    work.row = std::move(row.value());
    work.details = scheme.subject->details(*scheme.task, *submission->work, progress.part(0.7, 1.0));
    return work;
  } else {
    Error error = row.error();
    error.subject.clear();
    work.row.problem = describe(error);
  }
  if (submission && submission->attempt) work.row.attempt = *submission->attempt;
  return work;
}

Json toJson(const ClassReport& report) {
  Json works = Json::array();
  for (const ReportedWork& work : report.works) {
    const ClassRow& row = work.row;
    Json json = {{"file", row.file},
                 {"student", row.attempt.student},
                 {"handed_in", row.attempt.handedIn},
                 {"seconds", row.attempt.seconds},
                 {"cutting_s", work.details.seconds},
                 {"hints", row.attempt.hintCount()}};
    json["problem"] = row.problem.empty() ? Json() : Json(row.problem);
    json["points"] = row.marking.points;
    json["of"] = row.marking.of;
    json["marks"] = Json::array();
    for (const Mark& mark : row.marking.marks) json["marks"].push_back(jsonOf(report, mark));
    json["events"] = Json::array();
    for (const ReportEvent& event : work.details.events)
      json["events"].push_back({{"time_s", event.seconds}, {"text", event.text.inEnglish()}});
    works.push_back(std::move(json));
  }
  return {{"exercise", report.exercise.title}, {"of", report.exercise.points()}, {"submissions", std::move(works)}};
}

std::string readableText(const ClassReport& report) {
  std::string text;
  for (const ReportedWork& work : report.works) {
    const ClassRow& row = work.row;
    text +=
        (text.empty() ? "" : "\n") + row.file + (row.attempt.student.empty() ? "" : ", " + row.attempt.student) + ": ";
    if (!row.problem.empty()) {
      text += "not marked: " + row.problem + "\n";
      continue;
    }
    text += pointsText(row.marking) + "\n";
    for (const auto& cells : rowsOf(report, row.marking))
      text += "  " + cells[3] + "  " + cells[0] + ": " + cells[4] + "\n";
    for (const ReportEvent& event : work.details.events)
      text += "  " + minutesText(event.seconds) + ": " + event.text.inEnglish() + "\n";
  }
  return text;
}

std::string htmlOf(const ClassReport& report) {
  const auto image = [](const QImage& picture, const std::string& name) {
    return "<img style=\"max-width: 100%\" width=\"" + std::to_string(kPlotWidth) + "\" alt=\"" + name +
           "\" src=\"data:image/png;base64," + base64Png(picture) + "\"/>";
  };
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"/><title>" +
         escaped(report.exercise.title) +
         "</title>\n<style>body { font-family: sans-serif; max-width: 60em; margin: 2em auto; } "
         "table { border-collapse: collapse; }</style></head>\n<body>\n" +
         bodyOf(report, image) + "</body>\n</html>\n";
}

std::string pdfOf(const ClassReport& report) {
  QTextDocument document;
  const auto image = [&](const QImage& picture, const std::string& name) {
    document.addResource(QTextDocument::ImageResource, QUrl(QString::fromStdString(name)), picture);
    return "<img src=\"" + name + "\" width=\"" + std::to_string(kPlotWidth) + "\"/>";
  };
  document.setHtml(QString::fromStdString(bodyOf(report, image)));
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setTitle(QString::fromStdString(report.exercise.title));
  document.print(&writer);
  buffer.close();
  return buffer.data().toStdString();
}

Status writeReport(const ClassReport& report, const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending != ".html" && ending != ".pdf") return unknownEnding(path, {".html", ".pdf"});
  return writeFileAtomically(path, ending == ".pdf" ? pdfOf(report) : htmlOf(report));
}

}  // namespace handwheel
