// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "document/exercise/ExerciseSnapshot.h"

namespace handwheel {

// Document kind of exercises, students' copies of them and submissions.
class ExerciseKind : public DocumentKind {
 public:
  // subjects: the subjects that exercises can have, at least one. New exercises have the first subject.
  explicit ExerciseKind(std::vector<std::unique_ptr<ExerciseSubject>> subjects);

  std::span<const std::unique_ptr<ExerciseSubject>> subjects() const { return m_subjects; }

  std::string id() const override { return "exercise"; }
  std::string title() const override;
  // Returns the format of descriptions in JSON.
  std::vector<FileFormat> formats() const override;
  bool recognises(std::string_view head, std::string_view name) const override;
  Result<OpenedFile> import(const std::filesystem::path& path, const ReadOptions& options,
                            Progress progress) const override;
  Result<WrittenFile> exportTo(const Snapshot& content, const std::filesystem::path& path,
                               Progress progress) const override;
  void save(const Snapshot& content, Container& container) const override;
  // Loads an exercise. Problems with its content are added to the damage. Errors: SubjectUnknown {subject},
  // ElementMalformed, and the errors of loading the solution and the work.
  Result<SnapshotPointer> load(const Container& container, std::vector<Error>& damage,
                               Progress progress) const override;
  SnapshotPointer blank() const override { return blankOf(*m_subjects.front()); }
  // Returns a new exercise about one of the subjects.
  SnapshotPointer blankOf(const ExerciseSubject& subject) const;
  std::unique_ptr<Document> make(OpenedFile opened) const override;
  nlohmann::json describe(const Snapshot& content) const override;
  // Returns the display of the work or, if there is none, of the target.
  DisplayModel display(const Snapshot& content) const override;

  // Makes an exercise from a description. A description is the JSON of the document with a model solution that
  // ExerciseSubject::makeWork() reads. A description that is "for_students" gives a student's copy. Errors:
  // SubjectUnknown, ElementMalformed, Cancelled. Any damage is an error as well.
  Result<SnapshotPointer> fromDescription(const nlohmann::json& description, Progress progress) const;
  // Returns the description of an exercise, without solution, attempt and work. If the description that is read has no
  // key, the exercise gets a key that is the same whenever this description is read.
  static nlohmann::json description(const ExerciseSnapshot& exercise);

 private:
  Result<ExerciseSnapshot> read(const nlohmann::json& document, std::vector<Error>& damage) const;

  std::vector<std::unique_ptr<ExerciseSubject>> m_subjects;
};

// Returns a new key for an exercise, which is a UUID.
std::string newExerciseKey();

}  // namespace handwheel
