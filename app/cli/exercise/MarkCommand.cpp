// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/exercise/MarkCommand.h"

#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/ReportJson.h"
#include "document/AtomicFile.h"
#include "document/exercise/ExerciseErrors.h"
#include "report/exercise/MarkingReport.h"

#include <algorithm>
#include <optional>

namespace handwheel {

namespace {

std::shared_ptr<const ExerciseSnapshot> exerciseOf(const Result<OpenedFile>& opened) {
  return opened ? std::dynamic_pointer_cast<const ExerciseSnapshot>(opened->content) : nullptr;
}

// Returns a problem of the arguments, or an empty string.
std::string problemOf(const Arguments& arguments, const DocumentKinds& kinds) {
  const std::string ending = std::filesystem::path(arguments.valueOf("report")).extension().string();
  if (arguments.has("report") && ending != ".html" && ending != ".pdf")
    return "--report takes a name that ends in .html or .pdf.";
  const std::vector<std::filesystem::path> inputs(arguments.operands.begin(), arguments.operands.end());
  for (const char* const option : {"csv", "report"}) {
    if (!arguments.has(option)) continue;
    const std::filesystem::path path = arguments.valueOf(option);
    const bool isTable = std::string_view(option) == "csv";
    const std::string refusal =
        isTable ? refusalOfData("--csv", path, inputs, kinds) : refusalToOverwrite(path, inputs);
    if (!refusal.empty()) return refusal;
  }
  if (arguments.has("csv") && arguments.has("report") &&
      isSameFile(arguments.valueOf("csv"), arguments.valueOf("report")))
    return "The table and the report need a file each.";
  if (arguments.operands.size() < 2) return "Name the exercise, then what was handed in.";
  return {};
}

// Sorts by the heading of a column, or the name of a criterion. Returns false if there is none.
bool sortBy(std::vector<ReportedWork>& works, const Exercise& exercise, std::string_view heading) {
  SubmissionTable table(exercise);
  const bool isDescending = heading.starts_with("-");
  if (isDescending) heading.remove_prefix(1);
  std::size_t column = 0;
  while (column < table.columns() && table.heading(column) != heading) ++column;
  if (column == table.columns()) return false;
  for (const ReportedWork& work : works) table.add(work.row);
  table.sort(column, isDescending);
  std::vector<ReportedWork> sorted;
  for (const SubmissionRow& row : table.rows()) {
    const auto found = std::find_if(works.begin(), works.end(), [&](const ReportedWork& work) {
      return work.row.file == row.file && work.row.attempt == row.attempt;
    });
    sorted.push_back(std::move(*found));
    works.erase(found);
  }
  works = std::move(sorted);
  return true;
}

int writeFiles(const SubmissionsReport& report, const Arguments& arguments) {
  if (arguments.has("csv")) {
    SubmissionTable table(report.exercise);
    for (const ReportedWork& work : report.works) table.add(work.row);
    const Status written = writeFileAtomically(arguments.valueOf("csv"), table.csv());
    if (!written) return fail(written.error());
  }
  if (!arguments.has("report")) return kExitDone;
  const Status written = writeReport(report, arguments.valueOf("report"));
  return written ? kExitDone : fail(written.error());
}

int runMark(const Arguments& arguments, const DocumentKinds& kinds) {
  if (const std::string problem = problemOf(arguments, kinds); !problem.empty()) return failUsage(problem, "mark");
  std::optional<Result<OpenedFile>> opened;
  runInterruptible("Reading", [&](CommandJob& job) { opened = kinds.open(arguments.operands[0], {}, job.progress()); });
  if (!*opened) return fail(opened->error());
  const auto scheme = exerciseOf(*opened);
  if (!scheme) return refuse(arguments.operands[0] + " is not an exercise.");
  if (scheme->isForStudents) return fail({ExerciseError::WithoutScheme, {}, {}, arguments.operands[0]});

  SubmissionsReport report{scheme->exercise, measurementTypes(*scheme->subject), {}};
  bool isCancelled = false;
  runInterruptible("Marking", [&](CommandJob& job) {
    const std::size_t count = arguments.operands.size() - 1;
    const std::uint64_t mark = schemeMark(*scheme);
    for (std::size_t i = 0; i < count && !isCancelled; ++i) {
      const double share = 1.0 / static_cast<double>(count), done = share * static_cast<double>(i);
      report.works.push_back(markFile(*scheme, mark, arguments.operands[i + 1], kinds, sentenceFor,
                                      job.progress().part(done, done + share)));
      isCancelled = job.progress().cancelled();
    }
  });
  if (isCancelled) return fail({ErrorCode::Cancelled, {}, {}, {}});
  remarkEqualWorks(report.works);
  if (arguments.has("sort") && !sortBy(report.works, report.exercise, arguments.valueOf("sort")))
    return failUsage("There is no column “" + arguments.valueOf("sort") + "” to sort by.", "mark");
  if (const int code = writeFiles(report, arguments); code != kExitDone) return code;
  const int code = print(arguments.has("json") ? textOf(toJson(report)) : readableText(report));
  const bool isAll = std::all_of(report.works.begin(), report.works.end(),
                                 [](const ReportedWork& work) { return work.row.problem.empty(); });
  return code == kExitDone && !isAll ? kExitSomethingLeft : code;
}

bool drawsPlots(std::span<char* const> words) {
  return std::any_of(words.begin(), words.end(), [](std::string_view each) { return each.starts_with("--report"); });
}

}  // namespace

Command markCommand() {
  return {{"mark",
           "EXERCISE SUBMISSION [SUBMISSION...]",
           "Marks work that students have handed in, by the marking scheme of the teacher's exercise.\n"
           "The same files give the same marks. Exit code 0: all were marked; 2: some could not be, which the report "
           "says;\n"
           "1: error.",
           {
               {"json", 0, "", "Report as JSON"},
               {"report", 0, "FILE", "Write a report with marks, reasons and plots, as .html or .pdf"},
               {"csv", 0, "FILE", "Write the class as a table"},
               {"sort", 0, "COLUMN", "Sort by a column of that table: Points, or -Points for the best first"},
               {"help", 'h', "", "Show this help"},
           }},
          runMark,
          nullptr,
          drawsPlots};
}

}  // namespace handwheel
