// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/scene/BodyOperation.h"

#include "base/NumberText.h"
#include "document/OperationText.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyErrors.h"
#include "document/scene/BodyLinks.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RigidPose.h"
#include "tools/scene/PlaceParameters.h"

#include <QtGlobal>
#include <algorithm>
#include <numbers>

namespace handwheel {

namespace {

constexpr const char* kVerbs[] = {"add", "remove", "update", "unlink"};
constexpr const char* kOfAdding[] = {"link", "name", "at", "turn"};

// The primitive that a text names, "box:10,20,30"; null for other texts, which are file names.
const PrimitiveDescription* primitiveNamed(std::string_view text) {
  const std::string_view name = text.substr(0, text.find(':'));
  const auto all = primitives();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const PrimitiveDescription& each) { return each.id == name; });
  return name.size() == text.size() || found == all.end() ? nullptr : &*found;
}

Result<Body> primitiveFrom(const PrimitiveDescription& primitive, std::string_view numbers) {
  std::vector<double> dimensions;
  for (std::string_view word : parted(numbers, ',')) {
    ErrorCode why{};
    double value = 0.0;
    if (!parseDecimal(word, value, why)) return Error{why, {std::string(word)}, {}, {}};
    dimensions.push_back(value);
  }
  auto geometry = PrimitiveGeometry::make(primitive.primitive, std::move(dimensions));
  if (!geometry) return geometry.error();
  return Body{.name = primitive.id, .geometry = std::move(geometry).value()};
}

Result<ImportedBody> bodyToAdd(const OperationValues& values, const DocumentKinds& kinds, Progress progress) {
  const std::string what = values.text("add");
  const PrimitiveDescription* primitive = primitiveNamed(what);
  if (!primitive) return readBody(kinds, what, values.flag("link"), progress);
  Result<Body> body = primitiveFrom(*primitive, std::string_view(what).substr(what.find(':') + 1));
  if (!body) return body.error();
  return ImportedBody{std::move(body).value(), {}};
}

Result<BodyChange> adding(const OperationValues& values, const BodySet& bodies, ImportedBody read) {
  Body& body = read.body;
  body.name = values.isSet("name") ? values.text("name") : freeBodyName(bodies, body.name);
  body.pose = poseOf(vectorIn(values, "at"), vectorIn(values, "turn"));
  std::string name = body.name;
  Result<std::unique_ptr<Edit>> edit = addBodyEdit(bodies, std::move(body));
  if (!edit) return edit.error();
  return BodyChange{std::move(edit).value(), std::move(read.file), std::move(name)};
}

Result<BodyChange> updating(Body body, const BodySet& bodies, ImportedBody read) {
  const bool isSame = body.link && read.body.link->sha256 == body.link->sha256;
  if (!isSame) body.geometry = std::move(read.body.geometry);
  body.link = std::move(read.body.link);
  std::string name = body.name;
  Result<std::unique_ptr<Edit>> edit = changeBodyEdit(bodies, std::move(body));
  if (!edit) return edit.error();
  return BodyChange{std::move(edit).value(), std::move(read.file), std::move(name)};
}

Result<BodyChange> unlinking(Body body, const BodySet& bodies) {
  body.link.reset();
  std::string name = body.name;
  Result<std::unique_ptr<Edit>> edit = changeBodyEdit(bodies, std::move(body));
  if (!edit) return edit.error();
  return BodyChange{std::move(edit).value(), {}, std::move(name)};
}

}  // namespace

Result<BodyPointer> bodyCalled(const BodySet& bodies, const std::string& text) {
  const BodyPointer named = bodies.withName(text);
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [&](const BodyPointer& body) { return std::to_string(body->id) == text; });
  const BodyPointer numbered = found == bodies.end() ? nullptr : *found;
  if (named && numbered && named != numbered)
    return Error{BodyError::Ambiguous, {text, std::to_string(named->id)}, {}, {}};
  if (!named && !numbered) return Error{BodyError::BodyMissing, {text}, {}, {}};
  return named ? named : numbered;
}

const Operation& bodyOperation() {
  static const Operation operation = {
      .id = "body",
      .title = QT_TRANSLATE_NOOP("Tool", "Change bodies"),
      .meaning = "Add a body, remove it, or follow the file that it is linked to",
      .operands = "IN",
      .parameters = {
          wordParameter("add", "WHAT",
                        "Add the shape of a file, or box:X,Y,Z, cylinder:R,L, sphere:R or cone:R,L (mm, centred)"),
          {.property = {.id = "link", .group = {}, .label = {}, .value = false},
           .meaning = "Remember the file, to read it again when it has changed"},
          wordParameter("name", "NAME", "The name of the new body (default: that of the file or shape)"),
          threeNumbers("at", "X,Y,Z", "Position of the new body, in mm", Quantity::Length, kFarthestBody),
          threeNumbers("turn", "A,B,C", "Rotation about x, y and z in degrees, about its own origin", Quantity::Angle,
                       2.0 * std::numbers::pi),
          wordParameter("remove", "BODY", "Remove a body, given by name or number"),
          wordParameter("update", "BODY", "Read the linked file of a body again"),
          wordParameter("from", "FILE", "With --update: link the body to this file from now on, and read that"),
          wordParameter("unlink", "BODY", "Keep the shape of a body, and remove the link to its file"),
      }};
  return operation;
}

std::string problemOfBodyValues(const OperationValues& values) {
  const auto isGiven = [&](const char* id) { return values.isSet(id); };
  if (std::count_if(std::begin(kVerbs), std::end(kVerbs), isGiven) != 1)
    return "give one of --add, --remove, --update and --unlink";
  const auto stray = std::find_if(std::begin(kOfAdding), std::end(kOfAdding), isGiven);
  if (stray != std::end(kOfAdding) && !isGiven("add"))
    return std::string("--") + *stray + " is only possible with --add";
  if (isGiven("from") && !isGiven("update")) return "--from is only possible with --update";
  const std::string what = isGiven("add") ? values.text("add") : std::string();
  const PrimitiveDescription* primitive = primitiveNamed(what);
  if (!primitive) return {};
  if (isGiven("link")) return "--link is only possible with a file";
  const std::string numbers = what.substr(what.find(':') + 1);
  if (parted(numbers, ',').size() == primitive->dimensions.size()) return {};
  return std::string("a ") + primitive->id + " has " + std::to_string(primitive->dimensions.size()) +
         " dimension(s), not '" + numbers + "'";
}

bool readsFile(const OperationValues& values) {
  return values.isSet("update") || (values.isSet("add") && !primitiveNamed(values.text("add")));
}

Result<ImportedBody> bodyFrom(const OperationValues& values, const BodySet& bodies, const DocumentKinds& kinds,
                              const std::filesystem::path& folder, Progress progress) {
  if (values.isSet("add")) return bodyToAdd(values, kinds, progress);
  if (!values.isSet("update")) return ImportedBody{};
  const Result<BodyPointer> body = bodyCalled(bodies, values.text("update"));
  if (!body) return body.error();
  Result<ImportedBody> read = values.isSet("from") ? readBody(kinds, values.text("from"), true, progress)
                                                   : updatedFromLink(kinds, **body, folder, progress);
  if (read) read->body.id = (*body)->id;
  return read;
}

Result<BodyChange> bodyChange(const OperationValues& values, const BodySet& bodies, ImportedBody read) {
  if (values.isSet("add")) return adding(values, bodies, std::move(read));
  if (values.isSet("update")) {  // it may have another name by now
    const BodyPointer body = bodies.withId(read.body.id);
    if (!body) return Error{BodyError::BodyMissing, {values.text("update")}, {}, {}};
    return updating(*body, bodies, std::move(read));
  }
  const std::string verb = values.isSet("remove") ? "remove" : "unlink";
  const Result<BodyPointer> body = bodyCalled(bodies, values.text(verb));
  if (!body) return body.error();
  if (verb == "unlink") return unlinking(**body, bodies);
  const BodyId ids[] = {(*body)->id};
  return BodyChange{removeBodiesEdit(bodies, ids), {}, (*body)->name};
}

Result<BodyChange> bodyChange(const OperationValues& values, const BodySet& bodies, const DocumentKinds& kinds,
                              const std::filesystem::path& folder, Progress progress) {
  Result<ImportedBody> read = bodyFrom(values, bodies, kinds, folder, progress);
  if (!read) return read.error();
  return bodyChange(values, bodies, std::move(read).value());
}

}  // namespace handwheel
