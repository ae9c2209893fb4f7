// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ExerciseKind.h"

#include "base/JsonText.h"
#include "document/AtomicFile.h"
#include "document/Container.h"
#include "document/DocumentErrors.h"
#include "document/FileBytes.h"
#include "document/container/UnknownPart.h"
#include "document/exercise/ExerciseDocument.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ExerciseJson.h"

#include <QUuid>
#include <QtGlobal>
#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::json;

constexpr const char* kDescriptionEnding = ".exercise.json";
constexpr const char *kSolution = "solution", *kWork = "work", *kTask = "task", *kClass = "class";

const ExerciseSnapshot& exerciseOf(const Snapshot& content) {
  return static_cast<const ExerciseSnapshot&>(content);
}

std::string folderOf(const char* name) {
  return std::string("exercise/") + name + "/";
}

// A document within the document: its JSON under a key, its blobs in a folder of that name.
void writeInner(Container& container, const char* name, const DocumentKind& kind, const SnapshotPointer& content) {
  Json& document = (*container.manifest)["document"];
  document[name] = nullptr;
  if (!content) return;
  Container inner;
  kind.save(*content, inner);
  document[name] = std::move((*inner.manifest)["document"]);
  for (auto& [blob, bytes] : inner.blobs) container.blobs[folderOf(name) + blob] = std::move(bytes);
}

Result<SnapshotPointer> readInner(const Container& container, const char* name, const DocumentKind& kind,
                                  std::vector<Error>& damage, Progress progress) {
  const Json& document = (*container.manifest)["document"];
  const auto found = document.find(name);
  if (found == document.end() || found->is_null()) return SnapshotPointer();
  Container inner;
  (*inner.manifest)["document"] = *found;
  const std::string folder = folderOf(name);
  for (auto blob = container.blobs.lower_bound(folder); blob != container.blobs.end(); ++blob) {
    if (!blob->first.starts_with(folder)) break;
    inner.blobs[blob->first.substr(folder.size())] = blob->second;
  }
  Result<SnapshotPointer> content = kind.load(inner, damage, progress);
  if (content || content.error().code == ErrorCode::Cancelled) return content;
  damage.push_back(content.error());
  return SnapshotPointer();
}

Json withOthers(const ExerciseSnapshot& exercise, Json ours) {
  return exercise.others ? withUnknown(*exercise.others, std::move(ours)) : ours;
}

// Keeps the unknown keys of the JSON that an exercise was read from. known: known keys besides those of descriptions.
void keepOthers(ExerciseSnapshot& exercise, const Json& read, std::initializer_list<const char*> known) {
  Json others = keysBeyond(read, ExerciseKind::description(exercise));
  for (const char* const key : known) others.erase(key);
  others.erase(kTask);  // the subject keeps its own unknown keys
  if (const auto task = read.find(kTask); task != read.end())
    if (Json ofTask = exercise.subject->unknownKeys(*task, *exercise.task); !ofTask.empty())
      others[kTask] = std::move(ofTask);
  if (!others.empty()) exercise.others = std::make_shared<const Json>(std::move(others));
}

// Returns the key of a description without one: the same each time it is read, for the teacher and the students.
std::string keyOf(const ExerciseSnapshot& exercise) {
  static const QUuid kNames(QStringLiteral("8f0e3f7a-7f0b-4f0f-9c55-6f2a0c6d1b9e"));
  const Json named = {exercise.exercise.title, exercise.subject->id(), exercise.subject->toJson(*exercise.task)};
  return QUuid::createUuidV5(kNames, QByteArray::fromStdString(named.dump()))
      .toString(QUuid::WithoutBraces)
      .toStdString();
}

}  // namespace

std::string newExerciseKey() {
  return QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
}

ExerciseKind::ExerciseKind(std::vector<std::unique_ptr<ExerciseSubject>> subjects) : m_subjects(std::move(subjects)) {
  assert(!m_subjects.empty());
}

std::string ExerciseKind::title() const {
  return QT_TRANSLATE_NOOP("DocumentKind", "Exercise");
}

std::vector<FileFormat> ExerciseKind::formats() const {
  std::vector<FileFormat> all{{"Exercise", {kDescriptionEnding}, true, true}};
  for (const auto& subject : m_subjects) {
    for (FileFormat& format : subject->drawingFormats()) all.push_back(std::move(format));
  }
  return all;
}

bool ExerciseKind::recognises(std::string_view head, std::string_view name) const {
  return name.ends_with(kDescriptionEnding) && head.find("\"subject\"") != head.npos;
}

Result<OpenedFile> ExerciseKind::import(const std::filesystem::path& path, const ReadOptions&,
                                        Progress progress) const {
  const Result<std::string> text = readFileBytes(path);
  const Result<Json> json = text ? parseJson(*text, "exercise") : Result<Json>(text.error());
  Result<SnapshotPointer> content = json ? fromDescription(*json, progress) : Result<SnapshotPointer>(json.error());
  if (!content) {
    Error error = content.error();
    error.subject = path.string();
    return error;
  }
  OpenedFile opened;
  opened.kind = this;
  opened.content = std::move(content.value());
  return opened;
}

Result<WrittenFile> ExerciseKind::exportTo(const Snapshot& content, const std::filesystem::path& path,
                                           Progress progress) const {
  const ExerciseSnapshot& exercise = exerciseOf(content);
  if (!path.string().ends_with(kDescriptionEnding)) {
    Result<WrittenFile> drawing = exercise.subject->exportDrawing(exercise.exercise, *exercise.task, path, progress);
    if (drawing) drawing->isExport = true;
    return drawing;
  }
  WrittenFile file;
  Json json = withOthers(exercise, description(exercise));
  if (exercise.solution) json[kSolution] = exercise.subject->describeWork(*exercise.task, *exercise.solution);
  const bool isAsDescribed = exercise.solution && exercise.solution == exercise.madeOfDescription;
  if (isAsDescribed && !json[kSolution].is_null()) json[kSolution] = *exercise.describedSolution;
  if (exercise.solution && json[kSolution].is_null())
    file.notes.push_back(
        {QT_TRANSLATE_NOOP("Note",
                           "A description cannot contain a model solution that was made by hand; it was left out."),
         {},
         true});
  if (exercise.work) file.notes.push_back({QT_TRANSLATE_NOOP("Note", "The work is not in the description."), {}, true});
  if (exercise.marked)
    file.notes.push_back({QT_TRANSLATE_NOOP("Note", "The class and its marks are not in the description."), {}, true});
  file.isExport = !file.notes.empty();
  const std::string text = json.dump(1) + "\n";
  const Status written = writeFileAtomically(path, text, progress);
  if (!written) return written.error();
  file.bytes = text.size();
  return file;
}

void ExerciseKind::save(const Snapshot& content, Container& container) const {
  const ExerciseSnapshot& exercise = exerciseOf(content);
  Json& document = (*container.manifest)["document"];
  if (!document.is_object()) document = Json::object();
  document.update(withOthers(exercise, description(exercise)));
  document["attempt"] = exercise.attempt ? toJson(*exercise.attempt) : Json();
  if (exercise.marked) document[kClass] = toJson(*exercise.marked);
  writeInner(container, kSolution, exercise.subject->kind(), exercise.solution);
  writeInner(container, kWork, exercise.subject->kind(), exercise.work);
}

Result<SnapshotPointer> ExerciseKind::load(const Container& container, std::vector<Error>& damage,
                                           Progress progress) const {
  const auto document = container.manifest->find("document");
  if (document == container.manifest->end() || !document->is_object())
    return Error{ErrorCode::ElementMalformed, {"document", "it is missing"}, {}, {}};
  Result<ExerciseSnapshot> read = this->read(*document, damage);
  if (!read) return read.error();
  ExerciseSnapshot exercise = std::move(read.value());
  const auto isForStudents = document->find("for_students");
  exercise.isForStudents =
      isForStudents != document->end() && isForStudents->is_boolean() && isForStudents->get<bool>();
  const auto attempt = document->find("attempt");
  if (attempt != document->end() && attempt->is_object()) exercise.attempt = attemptFrom(*attempt, damage);
  // A copy for students never has any, whatever program wrote it.
  const auto marked = document->find(kClass);
  if (marked != document->end() && !exercise.isForStudents) {
    MarkedSubmissions works = markedSubmissionsFrom(*marked, damage);
    if (!works.empty()) exercise.marked = std::make_shared<const MarkedSubmissions>(std::move(works));
  }
  Result<SnapshotPointer> solution =
      readInner(container, kSolution, exercise.subject->kind(), damage, progress.part(0.0, 0.5));
  Result<SnapshotPointer> work =
      solution ? readInner(container, kWork, exercise.subject->kind(), damage, progress.part(0.5, 1.0))
               : Result<SnapshotPointer>(solution.error());
  if (!work) return work.error();
  exercise.solution = std::move(solution.value());
  exercise.work = std::move(work.value());
  keepOthers(exercise, *document, {kSolution, kWork, "attempt", kClass});
  return SnapshotPointer(std::make_shared<const ExerciseSnapshot>(std::move(exercise)));
}

Result<ExerciseSnapshot> ExerciseKind::read(const Json& document, std::vector<Error>& damage) const {
  const std::string subject = stringAt(document, "subject");
  const auto known =
      std::find_if(m_subjects.begin(), m_subjects.end(), [&](const auto& each) { return each->id() == subject; });
  if (known == m_subjects.end()) return Error{ExerciseError::SubjectUnknown, {subject}, {}, {}};
  ExerciseSnapshot exercise;
  exercise.subject = known->get();
  exercise.exercise = exerciseFrom(document, damage);
  for (MarkingCriterion& c : exercise.exercise.criteria) {
    if (c.tolerance.empty() || c.hasLimit()) continue;
    if (const Status applied = exercise.subject->applyTolerance(c); !applied) damage.push_back(applied.error());
  }
  exercise.task = exercise.subject->fromJson(document.value(kTask, Json()), damage);
  exercise.key = stringAt(document, "key");
  if (exercise.key.size() > 100) {
    exercise.key.clear();
    damage.push_back({ErrorCode::ElementMalformed, {"key", "it is too long"}, {}, {}});
  }
  return exercise;
}

SnapshotPointer ExerciseKind::blankOf(const ExerciseSubject& subject) const {
  ExerciseSnapshot exercise;
  exercise.key = newExerciseKey();
  exercise.subject = &subject;
  exercise.task = exercise.subject->blankTask();
  return std::make_shared<const ExerciseSnapshot>(std::move(exercise));
}

std::unique_ptr<Document> ExerciseKind::make(OpenedFile opened) const {
  return std::make_unique<ExerciseDocument>(std::move(opened));
}

Json ExerciseKind::describe(const Snapshot& content) const {
  const ExerciseSnapshot& exercise = exerciseOf(content);
  Json described = description(exercise);
  described["points"] = exercise.exercise.points();
  described["has_solution"] = exercise.solution != nullptr;
  described["attempt"] = exercise.attempt ? toJson(*exercise.attempt) : Json();
  described["work"] = exercise.work ? exercise.subject->kind().describe(*exercise.work) : Json();
  return described;
}

DisplayModel ExerciseKind::display(const Snapshot& content) const {
  const ExerciseSnapshot& exercise = exerciseOf(content);
  return exercise.work ? exercise.subject->kind().display(*exercise.work) : exercise.subject->display(*exercise.task);
}

Result<SnapshotPointer> ExerciseKind::fromDescription(const Json& given, Progress progress) const {
  if (!given.is_object()) return Error{ErrorCode::ElementMalformed, {"exercise", "an object was expected"}, {}, {}};
  std::vector<Error> damage;
  Result<ExerciseSnapshot> read = this->read(given, damage);
  if (!read) return read.error();
  if (!damage.empty()) return damage.front();
  ExerciseSnapshot exercise = std::move(read.value());
  for (const MarkingCriterion& c : exercise.exercise.criteria) {
    if (c.points > 0.0 && !c.hasLimit())
      return Error{ErrorCode::ElementMalformed, {namedInErrors(c), "it gives points without a limit"}, {}, {}};
  }
  if (exercise.key.empty()) exercise.key = keyOf(exercise);
  keepOthers(exercise, given, {kSolution});
  if (const auto solution = given.find(kSolution); solution != given.end() && !solution->is_null()) {
    Result<SnapshotPointer> made = exercise.subject->makeWork(*exercise.task, *solution, progress);
    if (!made) return made.error();
    exercise.solution = std::move(made.value());
    exercise.describedSolution = std::make_shared<const Json>(*solution);
    exercise.madeOfDescription = exercise.solution;
  }
  const auto isForStudents = given.find("for_students");
  if (isForStudents != given.end() && isForStudents->is_boolean() && isForStudents->get<bool>())
    exercise = forStudents(std::move(exercise));
  return SnapshotPointer(std::make_shared<const ExerciseSnapshot>(std::move(exercise)));
}

Json ExerciseKind::description(const ExerciseSnapshot& exercise) {
  Json json = toJson(exercise.exercise);
  json["subject"] = exercise.subject->id();
  json[kTask] = exercise.subject->toJson(*exercise.task);
  json["key"] = exercise.key;
  json["for_students"] = exercise.isForStudents;
  return json;
}

}  // namespace handwheel
