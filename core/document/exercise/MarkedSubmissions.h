// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSubject.h"
#include "exercise/SubmissionTable.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

struct ExerciseSnapshot;

// A student's submission after marking.
struct ReportedWork {
  SubmissionRow row;
  ReportDetails details;     // without pictures and curves if read from the file of the exercise
  std::string path = {};     // absolute path of the marked file, as bytes
  std::uint64_t scheme = 0;  // schemeMark() of the scheme that marked it
  bool isKept = false;       // true: read from the file of the exercise
};

// The marked submissions of a class, in the order in which they arrived. Only the teacher's document has them.
using MarkedSubmissions = std::vector<std::shared_ptr<const ReportedWork>>;

inline constexpr std::size_t kMostMarkedWorks = 5000;

// Returns a hash of the criteria that differs if marks may differ. Names do not change it.
std::uint64_t schemeMark(const Exercise& exercise);
// Returns a hash of everything that marks depend on: the criteria, and the task with its target. O(size of the task as
// JSON).
std::uint64_t schemeMark(const ExerciseSnapshot& exercise);

// Adds works to a class. A work with the path of an earlier work replaces the earlier work.
MarkedSubmissions withMarked(MarkedSubmissions marked, std::vector<ReportedWork> more);

// Returns the class as JSON for the file of an exercise; docs/format.md lists the keys. Pictures and curves are left
// out.
nlohmann::json toJson(const MarkedSubmissions& marked);
// Reads untrusted JSON. Invalid values are left out and added to the damage.
MarkedSubmissions markedSubmissionsFrom(const nlohmann::json& json, std::vector<Error>& damage);

}  // namespace handwheel
