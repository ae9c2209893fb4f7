// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSubject.h"
#include "exercise/SubmissionTable.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

struct ExerciseSnapshot;

// One student's work that was marked.
struct ReportedWork {
  SubmissionRow row;
  ReportDetails details;     // without pictures and curves where it was read from the file of the exercise
  std::string path = {};     // of the file that was marked, absolute, as bytes
  std::uint64_t scheme = 0;  // schemeMark() that it was marked by
  bool isKept = false;       // it was read from the file of the exercise
};

// What a class has handed in, as it was marked, in the order in which it came. The teacher's alone.
using MarkedSubmissions = std::vector<std::shared_ptr<const ReportedWork>>;

inline constexpr std::size_t kMostMarkedWorks = 5000;

// Tells criteria apart that may give other marks: not by their names.
std::uint64_t schemeMark(const Exercise& exercise);
// Tells apart what is marked by: the criteria, and the task, with its target. The size of the task as JSON.
std::uint64_t schemeMark(const ExerciseSnapshot& exercise);

// The class with more works. A file that was marked before takes the place of its row, by its path.
MarkedSubmissions withMarked(MarkedSubmissions marked, std::vector<ReportedWork> more);

// As the file of an exercise has it; docs/format.md lists the keys. Pictures and curves are left out.
nlohmann::json toJson(const MarkedSubmissions& marked);
// Reads untrusted JSON. What cannot be taken is left out and added to the damage.
MarkedSubmissions markedSubmissionsFrom(const nlohmann::json& json, std::vector<Error>& damage);

}  // namespace handwheel
