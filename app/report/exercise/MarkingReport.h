// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// The marks of a class of students, as the data of a report.
struct SubmissionsReport {
  Exercise exercise;
  std::vector<MeasurementType> figures;
  std::vector<ReportedWork> works;
};

// Marks a file that was handed in. If it cannot be marked, the row contains the problem in the words of `describe`.
// mark: schemeMark() of the scheme, which is the same for all files and expensive for a large task.
ReportedWork markFile(const ExerciseSnapshot& scheme, std::uint64_t mark, const std::filesystem::path& path,
                      const DocumentKinds& kinds, std::string (*describe)(const Error&), Progress progress);

// Adds a remark to each work whose recording equals another one entirely or for the most part: no hand repeats a motion
// exactly. The part is measured by the time in which the hand moves. O(works² + pieces · works that share a piece).
void remarkEqualWorks(std::vector<ReportedWork>& works);

// Returns the report on the works that an exercise stores for its class. Works that were marked by another scheme get a
// remark.
SubmissionsReport submissionsReportOf(const ExerciseSnapshot& exercise);

// Returns all measured values, marks and reasons as JSON, without pictures and curves.
nlohmann::ordered_json toJson(const SubmissionsReport& report);

// Returns the marks as plain text: for each student the remarks, the points and reason of each criterion, and the
// events.
std::string readableText(const SubmissionsReport& report);

// Returns the report as a self-contained HTML page: a table of the class, then the marks, events, pictures and plots of
// each student. It draws text, so a QGuiApplication must exist.
std::string htmlOf(const SubmissionsReport& report, Progress progress = {});
// Returns the report as PDF (A4).
std::string pdfOf(const SubmissionsReport& report, Progress progress = {});

// Writes the report as HTML or PDF, according to the extension of the path (.html or .pdf). Writes the whole file or
// nothing. May be called on any thread; takes seconds for a class. Errors: ExtensionUnknown, WriteFailed, Cancelled.
Status writeReport(const SubmissionsReport& report, const std::filesystem::path& path, Progress progress = {});

}  // namespace handwheel
