// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/AtomicFile.h"
#include "document/DocumentKind.h"
#include "plot/PlotExport.h"
#include "report/exercise/CurvePlot.h"
#include "report/exercise/MarkingReport.h"
#include "report/exercise/MarkingWords.h"
#include "report/exercise/PrintedPages.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QLocale>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>
#include <algorithm>
#include <functional>
#include <string_view>

namespace handwheel {

namespace {

constexpr int kPlotWidth = 640, kPlotHeight = 300;  // in pixels at 96 a inch
constexpr double kSharpness = 2.0;                  // resolution of the plots on paper

// Makes the element of an image.
using ImageElement = std::function<std::string(const QImage&, const std::string& name)>;

std::string escaped(const std::string& text) {
  return QString::fromStdString(text).toHtmlEscaped().toStdString();
}

// Names of students are also passed here: they are no words of the program, and stay.
std::string word(const char* text) {
  return translatedText({text, {}});
}

// A sentence of the report in HTML.
std::string said(const char* text, std::vector<std::string> arguments = {}) {
  return escaped(translatedText({text, std::move(arguments)}));
}

std::string cellsOf(const std::vector<std::string>& cells, const char* element) {
  std::string html = "<tr>";
  for (const std::string& cell : cells) {
    // A single word is not broken where its column is narrow.
    const bool isWord = std::string_view(element) == "th" && cell.find(' ') == cell.npos;
    html += std::string("<") + element + (isWord ? " style=\"white-space: nowrap\">" : ">") + escaped(cell) + "</" +
            element + ">";
  }
  return html + "</tr>\n";
}

// Returns true if the columns of the class can be headed by the names of the criteria. They are as wide as the longest
// words of these, which have to stand beside each other on a page of A4.
bool areNamesShort(const std::vector<MarkingCriterion>& criteria) {
  constexpr qsizetype kLongestName = 14, kRoom = 48;  // signs
  qsizetype width = 0;
  for (const MarkingCriterion& c : criteria) {
    const QString name = QString::fromStdString(c.name);
    if (name.isEmpty() || name.size() > kLongestName) return false;
    qsizetype longest = 0;
    for (const QString& word : name.split(QLatin1Char(' '))) longest = std::max(longest, word.size());
    width += longest + 1;
  }
  return width <= kRoom;
}

// The class on one page: the criteria are named where there is room, else numbered, and named below. More of them than
// fit on paper stand with each student only.
std::string submissionTable(const SubmissionsReport& report) {
  constexpr std::size_t kMostOnPaper = 16;
  SubmissionTable table(report.exercise);
  for (const ReportedWork& work : report.works) table.add(work.row);
  std::vector<std::size_t> columns = {SubmissionTable::Student, SubmissionTable::Minutes, SubmissionTable::Hints,
                                      SubmissionTable::Made,    SubmissionTable::Points,  SubmissionTable::Percent};
  const auto areCounted = [](const SubmissionRow& row) { return row.tries.has_value(); };
  if (std::any_of(table.rows().begin(), table.rows().end(), areCounted))
    columns.insert(std::find(columns.begin(), columns.end(), SubmissionTable::Points), SubmissionTable::Tries);
  std::vector<std::string> headings;
  for (const std::size_t column : columns) headings.push_back(translatedHeading(table.heading(column)));
  const std::size_t criteria = table.columns() - SubmissionTable::FirstCriterion;
  const bool fits = criteria <= kMostOnPaper, isNamed = areNamesShort(report.exercise.criteria);
  for (std::size_t i = 0; fits && i < criteria; ++i) {
    columns.push_back(SubmissionTable::FirstCriterion + i);
    headings.push_back(isNamed ? report.exercise.criteria[i].name : std::to_string(i + 1));
  }
  std::string html =
      "<table border=\"1\" cellspacing=\"0\" cellpadding=\"2\" width=\"100%\" "
      "style=\"font-size: 8pt\">\n" +
      cellsOf(headings, "th");
  for (std::size_t row = 0; row < table.rows().size(); ++row) {
    std::vector<std::string> cells;
    for (const std::size_t column : columns) {
      cells.push_back(table.cell(row, column));
      if (column == SubmissionTable::Made && !cells.back().empty()) cells.back() = translatedHeading(cells.back());
    }
    if (cells.front().empty()) cells.front() = table.rows()[row].file;
    html += cellsOf(cells, "td");
  }
  html += "</table>\n";
  if (!fits || isNamed) return html;
  html += "<p style=\"font-size: 8pt\">" +
          said(QT_TRANSLATE_NOOP("Note", "The numbered columns are the points of these criteria:")) + "</p>\n";
  html += "<ol style=\"font-size: 8pt\">\n";
  for (const MarkingCriterion& c : report.exercise.criteria) html += "<li>" + escaped(c.name) + "</li>\n";
  return html + "</ol>\n";
}

std::string nameOf(const ReportedWork& work) {
  return work.row.attempt.student.empty() ? work.row.file : work.row.attempt.student;
}

std::string figureLine(const SubmissionsReport& report, const ReportMeasurement& each) {
  const MeasurementType* const type = measurementType(report.figures, each.figure);
  if (!type) return {};
  const QString label = QCoreApplication::translate("Figure", type->label.c_str());
  return "<p>" + escaped(label.toStdString() + ": " + measuredText(each.value, type->unit) + unitAfter(type->unit)) +
         "</p>\n";
}

std::string workSection(const SubmissionsReport& report, const ReportedWork& work, const std::string& name,
                        const ImageElement& image) {
  const SubmissionRow& row = work.row;
  // On paper each student of a class begins a page, to be given away.
  const char* const heading = report.works.size() > 1 ? "<h2 style=\"page-break-before: always\">" : "<h2>";
  std::string html =
      heading + escaped(nameOf(work)) + "</h2>\n<p>" + said(QT_TRANSLATE_NOOP("Note", "File: %1"), {row.file});
  if (row.attempt.isHandedIn())
    html += "<br/>" + said(QT_TRANSLATE_NOOP("Note", "Handed in: %1"), {localTime(row.attempt.handedIn)});
  html += "</p>\n";
  for (const std::string& remark : row.remarks) html += "<p><b>" + escaped(remark) + "</b></p>\n";
  if (!row.problem.empty())
    return html + "<p><b>" + said(QT_TRANSLATE_NOOP("Note", "Not marked: %1"), {row.problem}) + "</b></p>\n";
  html += "<p><b>" + escaped(pointsText(row.marking)) + "</b><br/>" +
          said(QT_TRANSLATE_NOOP("Note", "Time: %1; recorded: %2. Hints looked at: %3."),
               {minutesText(row.attempt.seconds), minutesText(work.details.seconds),
                std::to_string(row.attempt.hintCount())}) +
          "</p>\n<table border=\"1\" cellspacing=\"0\" cellpadding=\"4\">\n" +
          cellsOf({word(QT_TRANSLATE_NOOP("Note", "Criterion")), word(QT_TRANSLATE_NOOP("Note", "Limits")),
                   word(QT_TRANSLATE_NOOP("Note", "Measured")), word(QT_TRANSLATE_NOOP("Note", "Points")),
                   word(QT_TRANSLATE_NOOP("Note", "Reason"))},
                  "th");
  for (const auto& cells : rowsOf(report, row.marking)) {
    html += "<tr>";
    for (const std::string& cell : cells) html += "<td>" + escaped(cell) + "</td>";
    html += "</tr>\n";
  }
  html += "</table>\n";
  for (const ReportMeasurement& each : work.details.figures) html += figureLine(report, each);
  if (work.isKept)
    html +=
        "<p>" +
        said(QT_TRANSLATE_NOOP("Note", "Pictures and curves are not kept: mark the file again to have them here.")) +
        "</p>\n";
  if (!work.details.events.empty()) {
    html += "<h3>" + said(QT_TRANSLATE_NOOP("Note", "Events")) + "</h3>\n<ul>\n";
    for (const ReportEvent& event : work.details.events)
      html += "<li>" + momentOf(event) + escaped(translatedText(event.text)) + "</li>\n";
    html += "</ul>\n";
  }
  for (std::size_t i = 0; i < work.details.pictures.size(); ++i) {
    const ReportPicture& picture = work.details.pictures[i];
    html += "<p>" + image(picture.image, name + "-picture-" + std::to_string(i)) + "<br/>" +
            escaped(translatedText(picture.caption)) + "</p>\n";
  }
  for (std::size_t i = 0; i < work.details.curves.size(); ++i) {
    const Plot plot = plotOf(work.details.curves[i]);
    const QImage drawn = plotImage({&plot, 1}, {kPlotWidth, kPlotHeight}, ThemeKind::Light, kSharpness);
    html += "<p>" + image(drawn, name + "-" + std::to_string(i)) + "</p>\n";
  }
  return html;
}

// Two works over the same time: each curve of the one with that of the other, and what happened when.
std::string sideBySide(const ReportedWork& first, const ReportedWork& second, const ImageElement& image) {
  std::string html =
      "<h2>" + said(QT_TRANSLATE_NOOP("Note", "Side by side: %1, %2"), {nameOf(first), nameOf(second)}) + "</h2>\n";
  html += "<table border=\"1\" cellspacing=\"0\" cellpadding=\"4\">\n" +
          cellsOf({"", nameOf(first), nameOf(second)}, "th") +
          cellsOf({word(QT_TRANSLATE_NOOP("Note", "Points")), pointsText(first.row.marking),
                   pointsText(second.row.marking)},
                  "td") +
          cellsOf({word(QT_TRANSLATE_NOOP("Note", "Recorded")), minutesText(first.details.seconds),
                   minutesText(second.details.seconds)},
                  "td") +
          cellsOf({word(QT_TRANSLATE_NOOP("Note", "Events")), std::to_string(first.details.events.size()),
                   std::to_string(second.details.events.size())},
                  "td") +
          "</table>\n";
  int number = 0;
  for (const ReportCurve& curve : first.details.curves) {
    const auto& others = second.details.curves;
    const auto other = std::find_if(others.begin(), others.end(), [&](const ReportCurve& each) {
      return each.title == curve.title && each.xUnit == curve.xUnit && each.yUnit == curve.yUnit;
    });
    if (curve.xUnit != "s" || other == others.end() || curve.series.empty() || other->series.empty()) continue;
    ReportCurve both = curve;
    both.series = {curve.series.front(), other->series.front()};
    both.series[0].name = nameOf(first);
    both.series[1].name = nameOf(second);
    const Plot plot = plotOf(both);
    const QImage drawn = plotImage({&plot, 1}, {kPlotWidth, kPlotHeight}, ThemeKind::Light, kSharpness);
    html += "<p>" + image(drawn, "both-" + std::to_string(number++)) + "</p>\n";
  }
  return html;
}

// The lines of a text, as they are.
std::string linesOf(const std::string& text) {
  std::string html = escaped(text);
  for (std::size_t at = html.find('\n'); at != std::string::npos; at = html.find('\n', at))
    html.replace(at, 1, "<br/>");
  return html;
}

std::string bodyOf(const SubmissionsReport& report, const ImageElement& image, Progress progress) {
  std::string html = "<h1>" + escaped(report.exercise.title) + "</h1>\n";
  if (!report.exercise.text.empty()) html += "<p>" + linesOf(report.exercise.text) + "</p>\n";
  if (report.works.size() > 1) html += submissionTable(report);
  const bool areTwo =
      report.works.size() == 2 && report.works[0].row.problem.empty() && report.works[1].row.problem.empty();
  if (areTwo) html += sideBySide(report.works[0], report.works[1], image);
  for (std::size_t i = 0; i < report.works.size() && !progress.cancelled(); ++i) {
    html += workSection(report, report.works[i], "work" + std::to_string(i), image);
    progress.set(static_cast<double>(i + 1) / static_cast<double>(report.works.size()));
  }
  return html;
}

std::string base64Png(const QImage& picture) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  picture.save(&buffer, "PNG");
  return buffer.data().toBase64().toStdString();
}

}  // namespace

std::string htmlOf(const SubmissionsReport& report, Progress progress) {
  const auto image = [](const QImage& picture, const std::string& name) {
    return "<img style=\"max-width: 100%\" width=\"" + std::to_string(kPlotWidth) + "\" alt=\"" + name +
           "\" src=\"data:image/png;base64," + base64Png(picture) + "\"/>";
  };
  return "<!DOCTYPE html>\n<html lang=\"" + word(QT_TRANSLATE_NOOP("Note", "en")) +
         "\">\n<head><meta charset=\"utf-8\"/><title>" + escaped(report.exercise.title) +
         "</title>\n<style>body { font-family: sans-serif; max-width: 60em; margin: 2em auto; } "
         "table { border-collapse: collapse; }</style></head>\n<body>\n" +
         bodyOf(report, image, progress) + "</body>\n</html>\n";
}

std::string pdfOf(const SubmissionsReport& report, Progress progress) {
  QTextDocument document;
  const auto image = [&](const QImage& picture, const std::string& name) {
    document.addResource(QTextDocument::ImageResource, QUrl(QString::fromStdString(name)), picture);
    return "<img src=\"" + name + "\" width=\"" + std::to_string(kPlotWidth) + "\"/>";
  };
  document.setHtml(QString::fromStdString(bodyOf(report, image, progress.part(0.0, 0.7))));
  if (progress.cancelled()) return {};
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setTitle(QString::fromStdString(report.exercise.title));
  printWholeRows(document, writer);
  buffer.close();
  return buffer.data().toStdString();
}

Status writeReport(const SubmissionsReport& report, const std::filesystem::path& path, Progress progress) {
  const std::string ending = path.extension().string();
  if (ending != ".html" && ending != ".pdf") return unknownEnding(path, {".html", ".pdf"});
  const Progress drawing = progress.part(0.0, 0.95);
  const std::string bytes = ending == ".pdf" ? pdfOf(report, drawing) : htmlOf(report, drawing);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return writeFileAtomically(path, bytes, progress.part(0.95, 1.0));
}

}  // namespace handwheel
