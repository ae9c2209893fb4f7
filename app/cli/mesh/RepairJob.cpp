// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RepairJob.h"

#include "cli/Input.h"
#include "cli/mesh/UnmodifiedVerticesCheck.h"
#include "document/formats/MeshExport.h"
#include "document/formats/threemf/ThreeMfWriter.h"
#include "document/mesh/MeshKind.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/Weld.h"

#include <algorithm>
#include <chrono>

namespace handwheel {

namespace {

const Error kCancelled{ErrorCode::Cancelled, {}, {}, {}};

// Vertices of the input among both lists, each once.
std::vector<Vertex> modifiedInputs(std::vector<Vertex> repaired, const std::vector<Vertex>& parted,
                                   std::size_t inputVertices) {
  repaired.insert(repaired.end(), parted.begin(), parted.end());
  std::erase_if(repaired, [&](Vertex v) { return v >= inputVertices; });
  std::sort(repaired.begin(), repaired.end());
  repaired.erase(std::unique(repaired.begin(), repaired.end()), repaired.end());
  return repaired;
}

// The loops to leave open, by both of their names.
struct KeptLoops {
  std::set<int> ids;
  std::set<Vertex> keys;
};

// The input of a repair, and what has been made of it so far.
struct Work {
  Input input;
  std::optional<NumberType> numbers;  // in which the output holds coordinates; none: as they are, in a container
  BuiltMesh before;
  KeptLoops kept;
  HalfEdgeMesh after;
};

// The format of the output; none for a container, which holds what the document holds.
Result<std::optional<MeshFormat>> formatFor(const std::filesystem::path& output) {
  if (isContainerName(output)) return std::optional<MeshFormat>();
  const Result<MeshFormat> format = formatForOutput(output);
  if (!format) return format.error();
  return std::optional<MeshFormat>(*format);
}

// The largest distance that this moves a vertex by.
double roundPositions(HalfEdgeMesh& mesh, NumberType numbers) {
  double most = 0.0;
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
    const Vec3 p = rounded(mesh.position(v), numbers);
    if (p == mesh.position(v)) continue;
    most = std::max(most, (p - mesh.position(v)).norm());
    mesh.setPosition(v, p);
  }
  return most;
}

double roundSoup(TriangleSoup& soup, NumberType numbers) {
  const std::vector<Vec3> were = soup.points;
  roundPoints(soup, numbers);
  double most = 0.0;
  for (std::size_t i = 0; i < were.size(); ++i) most = std::max(most, (soup.points[i] - were[i]).norm());
  return most;
}

// The mesh of a document keeps its numbers, by which its loops are known.
BuiltMesh meshToRepair(Input& input, std::optional<NumberType> numbers, double& roundingMove, Progress progress) {
  if (const MeshSnapshot* document = input.meshDocument()) {
    BuiltMesh built{document->mesh.mesh, {}};
    if (numbers) roundingMove = roundPositions(built.mesh, *numbers);
    if (roundingMove > 0.0) built.report = relink(built.mesh);
    return built;
  }
  if (numbers) roundingMove = roundSoup(input.mesh->soup, *numbers);
  return buildMesh(input.mesh->soup, progress);
}

// Those asked for, and those that a document marks. Unknown are the ids that there are no loops for.
KeptLoops loopsToKeep(const Input& input, const HalfEdgeMesh& mesh, const std::set<int>& asked,
                      std::vector<int>& unknown) {
  KeptLoops kept;
  std::set<int> missing = asked;
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh)) {
    missing.erase(loop.id);
    const Vertex key = keyOf(mesh, loop);
    const bool isMarked = input.meshDocument() && input.meshDocument()->keptOpen.contains(key);
    if (!isMarked && !asked.contains(loop.id)) continue;
    kept.ids.insert(loop.id);
    kept.keys.insert(key);
  }
  unknown.assign(missing.begin(), missing.end());
  return kept;
}

// The document of the input with another mesh, and with marks for the loops that were asked to be kept open.
MeshSnapshot repairedDocument(const Work& work, Progress progress) {
  MeshSnapshot repaired;
  const MeshSnapshot* document = work.input.meshDocument();
  repaired.build = document ? document->build : std::make_shared<const BuildReport>(work.before.report);
  repaired.keptOpen = work.kept.keys;
  if (document) repaired.keptOpen.insert(document->keptOpen.begin(), document->keptOpen.end());
  repaired.numbers = work.input.mesh->numbers;
  repaired.mesh = inspected(work.after, tolerance::kNearWeld, progress);
  return repaired;
}

Result<EncodedMesh> encode(const Work& work, const std::filesystem::path& output, Progress progress) {
  if (work.numbers) return encodeMesh(work.after, *work.numbers, output, progress);
  const OpenedFile& opened = work.input.opened;
  const MeshSnapshot repaired = repairedDocument(work, progress.part(0.0, 0.5));
  Result<std::string> bytes = checkedContainer(*opened.kind, opened.file, repaired, output, progress.part(0.5, 1.0));
  if (!bytes) return bytes.error();
  EncodedMesh encoded;
  encoded.bytes = std::move(bytes.value());
  return encoded;
}

// Returns the contents of a file with these bytes, as readMeshInput() gives them.
Result<Input> decode(std::string_view bytes, bool isContainer, const DocumentKinds& kinds, Progress progress) {
  Input input;
  if (isContainer) {
    Result<OpenedFile> opened = kinds.openContainer(bytes, progress);
    if (!opened) return opened.error();
    input.opened = std::move(opened.value());
    const auto& content = static_cast<const MeshSnapshot&>(*input.opened.content);
    input.mesh = MeshInput{content.numbers, content.mesh.mesh.compact().soup};
    return input;
  }
  Result<MeshFile> file = readMesh(bytes, {}, {}, progress);
  if (!file) return file.error();
  input.mesh = MeshInput{file->numbers, std::move(file->soup)};
  return input;
}

// Measures the output, and checks that every unmodified vertex is in it.
Status measure(const RepairRequest& request, const DocumentKinds& kinds, const Work& work, RepairRun& run,
               Progress progress) {
  const Result<Input> written = decode(run.output, !work.numbers, kinds, progress.part(0.0, 0.3));
  if (!written) {
    Error error = written.error();
    error.subject = request.output.string();
    return error;
  }
  run.unmodifiedIdentical = unmodifiedAreIdentical(work.before.mesh, work.after, run.modified, written->mesh->soup);
  run.after = reportOn(*written, SelfIntersections::Count, progress.part(0.3, 0.9));
  // The numbers read again are unchanged: only the word for their unit differs.
  if (request.unit != LengthUnit::Millimetre && work.numbers &&
      formatForName(request.output.string()) == MeshFormat::ThreeMf)
    run.output = writeThreeMf(written->mesh->soup, *work.numbers, request.unit, progress.part(0.9, 1.0));
  return progress.cancelled() ? Status(kCancelled) : Status(Done{});
}

}  // namespace

Result<RepairRun> repairFile(const RepairRequest& request, const DocumentKinds& kinds, Progress progress) {
  const auto start = std::chrono::steady_clock::now();
  const Result<std::optional<MeshFormat>> format = formatFor(request.output);
  if (!format) return format.error();
  Result<Input> input = readMeshInput(request.input, request.read, kinds, progress.part(0.0, 0.1));
  if (!input) return input.error();

  RepairRun run;
  run.file = input->opened.file;
  run.refusal = refusalToReplace(request.output, run.file);
  if (!run.refusal.empty()) return run;
  if (request.inspectInput) run.before = reportOn(*input, SelfIntersections::Count, progress.part(0.1, 0.2));
  Work work{std::move(input.value()), {}, {}, {}, {}};
  if (*format) work.numbers = numberTypeOf(**format, work.input.mesh->numbers);
  work.before = meshToRepair(work.input, work.numbers, run.roundingMove, progress.part(0.2, 0.25));
  // The sentences on new debris compare with these numbers.
  if (!request.inspectInput) run.before.debris = countDebris(findComponents(work.before.mesh));
  if (progress.cancelled()) return kCancelled;
  work.kept = loopsToKeep(work.input, work.before.mesh, request.options.keepOpen, run.unknownLoops);
  if (!run.unknownLoops.empty()) return run;

  RepairOptions options = request.options;
  options.keepOpen = work.kept.ids;
  options.fill.numbers = work.numbers.value_or(work.input.mesh->numbers);
  work.after = work.before.mesh;
  run.repair = repair(work.after, options, progress.part(0.25, 0.75));
  if (run.repair.cancelled || progress.cancelled()) return kCancelled;
  run.nothingLeft = work.after.liveFaceCount() == 0;
  if (run.nothingLeft) return run;

  Result<EncodedMesh> encoded = encode(work, request.output, progress.part(0.75, 0.85));
  if (!encoded) return encoded.error();
  run.output = std::move(encoded->bytes);
  run.repair.reversedFaces += work.before.report.reversedFaces.size();
  run.repair.separatedVertices += encoded->report.parted.size();
  run.modified = modifiedInputs(run.repair.modifiedVertices, encoded->report.parted, work.before.mesh.vertexSlots());
  const Status measured = measure(request, kinds, work, run, progress.part(0.85, 1.0));
  if (!measured) return measured.error();
  if (request.compare) {
    Result<Deviation> deviating = deviation(work.after, work.before.mesh, {}, progress.part(0.99, 1.0));
    if (!deviating) return deviating.error();
    run.deviation = std::move(*deviating);
  }
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

}  // namespace handwheel
