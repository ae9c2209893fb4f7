// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/StepShape.h"

#include "step/LibraryProgress.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <istream>
#include <streambuf>

namespace handwheel {

namespace {

// mm; gaps between adjacent faces in files, due to rounding by their writers.
constexpr double kSewing = 1e-3;

Error notReadable(const char* reason) {
  return {ErrorCode::LibraryFailed, {reason}, {}, {}};
}

// Reads from memory without a copy.
class ViewBuffer : public std::streambuf {
 public:
  explicit ViewBuffer(std::string_view bytes) {
    char* const begin = const_cast<char*>(bytes.data());  // never written to
    setg(begin, begin, begin + bytes.size());
  }
};

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum what, TopAbs_ShapeEnum notWithin = TopAbs_SHAPE) {
  int number = 0;
  for (TopExp_Explorer each(shape, what, notWithin); each.More(); each.Next()) ++number;
  return number;
}

// Returns the solids unchanged, and the other faces sewn.
TopoDS_Shape sewn(const TopoDS_Shape& shape, const Message_ProgressRange& range) {
  BRepBuilderAPI_Sewing sewing(kSewing);
  bool isNeeded = false;
  for (TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SOLID); face.More(); face.Next(), isNeeded = true)
    sewing.Add(face.Current());
  if (!isNeeded) return shape;
  sewing.Perform(range);
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) builder.Add(all, solid.Current());
  if (!sewing.SewedShape().IsNull()) builder.Add(all, sewing.SewedShape());
  return all;
}

// Returns the unit as named in the file, which is not trusted: characters outside printable ASCII become a question
// mark.
std::string lengthUnit(STEPControl_Reader& reader) {
  TColStd_SequenceOfAsciiString lengths, angles, solidAngles;
  reader.FileUnits(lengths, angles, solidAngles);
  std::string unit = lengths.IsEmpty() ? std::string() : lengths.First().ToCString();
  std::replace_if(
      unit.begin(), unit.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return unit;
}

}  // namespace

Result<StepShape> readShape(std::string_view bytes, Progress progress) {
  ViewBuffer buffer(bytes);
  std::istream stream(&buffer);
  STEPControl_Reader reader;  // lengths become millimetres
  if (reader.ReadStream("file", stream) != IFSelect_RetDone) return notReadable("it is not a STEP file");
  progress.set(0.3);
  const Handle(LibraryProgress) indicator = new LibraryProgress(progress.part(0.3, 1.0));
  Message_ProgressScope scope(indicator->Start(), nullptr, 2);
  StepShape read;
  read.parts = reader.NbRootsForTransfer();
  read.partsRead = reader.TransferRoots(scope.Next());
  const TopoDS_Shape shape = reader.OneShape();
  if (shape.IsNull()) return notReadable("the file contains no shape");
  read.unit = lengthUnit(reader);
  read.solids = count(shape, TopAbs_SOLID);
  read.openShells = count(shape, TopAbs_SHELL, TopAbs_SOLID) + count(shape, TopAbs_FACE, TopAbs_SHELL);
  read.shape = sewn(shape, scope.Next());
  return read;
}

}  // namespace handwheel
