// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// The marks of a class for a report.
struct SubmissionsReport {
  Exercise exercise;
  std::vector<MeasurementType> figures;
  std::vector<ReportedWork> works;
};

// Marks a file that was handed in. If it cannot be marked, the row has its problem, as `describe` words the error.
// mark: schemeMark() of the scheme, whose cost grows with the task, and which is the same for all files.
ReportedWork markFile(const ExerciseSnapshot& scheme, std::uint64_t mark, const std::filesystem::path& path,
                      const DocumentKinds& kinds, std::string (*describe)(const Error&), Progress progress);

// Adds a remark to works whose recording, or the larger part of it, is the same as that of another one: nobody moves
// twice alike. The larger part is measured in time moved by hand. O(works² + pieces), and for each piece the works that
// have it.
void remarkEqualWorks(std::vector<ReportedWork>& works);

// Returns the report on the works that an exercise stores for its class. Works that were marked by another scheme say
// so in a remark.
SubmissionsReport submissionsReportOf(const ExerciseSnapshot& exercise);

// Returns all measured values, marks and reasons as JSON, without pictures and curves.
nlohmann::ordered_json toJson(const SubmissionsReport& report);

// Returns the marks for people: for each student a table of sizes, limits, points and reasons.
std::string readableText(const SubmissionsReport& report);

// Returns the report as a self-contained HTML page with the class as a table, then each student with marks, events,
// pictures and plots. Needs fonts, so a QGuiApplication.
std::string htmlOf(const SubmissionsReport& report, Progress progress = {});
// Returns the report as PDF (A4).
std::string pdfOf(const SubmissionsReport& report, Progress progress = {});

// Writes the report as .html or .pdf, by the extension of the path. Writes the whole file or nothing. Errors:
// ExtensionUnknown, WriteFailed, Cancelled. Any thread; seconds for a class.
Status writeReport(const SubmissionsReport& report, const std::filesystem::path& path, Progress progress = {});

}  // namespace handwheel
