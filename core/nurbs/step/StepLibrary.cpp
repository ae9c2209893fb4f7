// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/step/StepLibrary.h"

#include "base/Tolerance.h"
#include "nurbs/SurfaceOfRevolution.h"
#include "nurbs/UnitCircle.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>
#include <Precision.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <gp_Pln.hxx>
#include <mutex>
#include <sstream>

namespace handwheel {

namespace {

constexpr std::size_t kMostFaces = 10'000;  // a thousand take the library about one second to join, and three to read

Error cancelledError() {
  return {ErrorCode::Cancelled, {}, {}, {}};
}

Error libraryError(const char* reason) {
  return {ErrorCode::LibraryFailed, {"Open CASCADE", reason ? reason : ""}, {}, {}};
}

// Passes a Progress to the library, which checks from time to time if it should stop.
class Indicator : public Message_ProgressIndicator {
 public:
  explicit Indicator(Progress progress) : m_progress(progress) {}
  Standard_Boolean UserBreak() override { return m_progress.cancelled(); }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override { m_progress.set(GetPosition()); }

 private:
  Progress m_progress;
};

// The library's STEP translators and its messages live in global variables. One for all: a variable of the template
// below would be one for each kind of work.
std::mutex libraryMutex;

template <class Work>
auto withLibrary(Work work) -> decltype(work()) {
  const std::lock_guard<std::mutex> lock(libraryMutex);
  try {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    return work();
  } catch (const Standard_Failure& failure) {
    return libraryError(failure.GetMessageString());
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::OutOfMemory, {}, {}, {}};
  }
}

// Knots in the form of the library: each value once, with its multiplicity.
struct Knots {
  explicit Knots(const std::vector<double>& all) {
    for (double knot : all) {
      if (values.empty() || values.back() != knot) {
        values.push_back(knot);
        multiplicities.push_back(0);
      }
      ++multiplicities.back();
    }
  }
  TColStd_Array1OfReal valueArray() const { return {values.front(), 1, static_cast<int>(values.size())}; }
  TColStd_Array1OfInteger multiplicityArray() const {
    return {multiplicities.front(), 1, static_cast<int>(multiplicities.size())};
  }

  std::vector<double> values;
  std::vector<int> multiplicities;
};

Handle(Geom_BSplineSurface) mantleOf(const ProfileCurve& piece) {
  const SurfaceNurbs nurbs = SurfaceOfRevolution(piece).nurbs();
  const int columns = static_cast<int>(nurbs.poles.size()), rows = static_cast<int>(nurbs.poles[0].size());
  TColgp_Array2OfPnt poles(1, columns, 1, rows);
  TColStd_Array2OfReal weights(1, columns, 1, rows);
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const Vec3& p = nurbs.poles[i][j];
      poles.SetValue(i + 1, j + 1, gp_Pnt(p.x(), p.y(), p.z()));
      weights.SetValue(i + 1, j + 1, nurbs.weights[i][j]);
    }
  }
  const Knots circle(nurbs.circleKnots), profile(nurbs.profileKnots);
  return new Geom_BSplineSurface(poles, weights, circle.valueArray(), profile.valueArray(), circle.multiplicityArray(),
                                 profile.multiplicityArray(), 2, nurbs.profileDegree);
}

// Returns the flat end at a height: a disc bounded by the mantle's own circle.
TopoDS_Face discOf(const ProfilePoint& rim) {
  const auto circlePoles = unit_circle::poles();
  const auto circleWeights = unit_circle::weights();
  TColgp_Array1OfPnt poles(1, 9);
  TColStd_Array1OfReal weights(1, 9);
  for (int i = 0; i < 9; ++i) {
    const Eigen::Vector2d p = rim.x() * circlePoles[i];
    poles.SetValue(i + 1, gp_Pnt(p.x(), p.y(), rim.y()));
    weights.SetValue(i + 1, circleWeights[i]);
  }
  const Knots knots(unit_circle::knots());
  const Handle(Geom_BSplineCurve) circle =
      new Geom_BSplineCurve(poles, weights, knots.valueArray(), knots.multiplicityArray(), 2);
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire();
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, rim.y()), gp_Dir(0, 0, 1)), wire).Face();
}

// Returns a straight line of higher degree with degree 1, so that its surface has two rows of poles.
ProfileNurbs withoutExcess(ProfileNurbs piece) {
  const bool isLine = piece.degree == 2 && piece.poles.size() == 3 && piece.weights[0] == piece.weights[1] &&
                      piece.weights[1] == piece.weights[2] &&
                      piece.poles[1] == ProfilePoint(0.5 * (piece.poles[0] + piece.poles[2]));
  if (!isLine) return piece;
  const double from = piece.knots.front(), to = piece.knots.back();
  return {1, {from, from, to, to}, {piece.poles[0], piece.poles[2]}, {1.0, 1.0}};
}

// Returns the profile split where it may have corners: other programs do not expect them within a surface. Pieces
// without extent or on the axis are left out.
std::vector<ProfileCurve> smoothPieces(const ProfileCurve& profile) {
  const ProfileNurbs& nurbs = profile.nurbs();
  const auto degree = static_cast<std::size_t>(nurbs.degree);
  std::vector<ProfileCurve> pieces;
  std::size_t first = 0;
  for (std::size_t i = 1; i < nurbs.poles.size(); ++i) {
    const bool isEnd = i + 1 == nurbs.poles.size();
    if (!isEnd && nurbs.knots[i + 1] != nurbs.knots[i + degree]) continue;
    ProfileNurbs piece;
    piece.degree = nurbs.degree;
    piece.poles.assign(nurbs.poles.begin() + first, nurbs.poles.begin() + i + 1);
    piece.weights.assign(nurbs.weights.begin() + first, nurbs.weights.begin() + i + 1);
    piece.knots.assign(nurbs.knots.begin() + first, nurbs.knots.begin() + i + degree + 2);
    piece.knots.front() = piece.knots[1];
    piece.knots.back() = piece.knots[piece.knots.size() - 2];
    first = i;
    const auto isPoint = [&](const ProfilePoint& p) { return p == piece.poles.front(); };
    const auto isOnAxis = [](const ProfilePoint& p) { return p.x() == 0.0; };
    if (std::all_of(piece.poles.begin(), piece.poles.end(), isPoint)) continue;
    if (std::all_of(piece.poles.begin(), piece.poles.end(), isOnAxis)) continue;
    pieces.push_back(ProfileCurve::make(withoutExcess(std::move(piece))).value());
  }
  return pieces;
}

Result<TopoDS_Solid> solidOf(const ProfileCurve& profile, const Message_ProgressRange& range) {
  BRepBuilderAPI_Sewing sewing(Precision::Confusion());
  const std::vector<ProfileCurve> pieces = smoothPieces(profile);
  if (pieces.empty()) return Error{ErrorCode::ElementMalformed, {"profile", "it lies on the axis"}, {}, {}};
  if (pieces.size() > kMostFaces) {
    return Error{ErrorCode::FileTooLarge, {"faces", std::to_string(pieces.size()), std::to_string(kMostFaces)}, {}, {}};
  }
  for (const ProfileCurve& piece : pieces) {
    sewing.Add(BRepBuilderAPI_MakeFace(mantleOf(piece), Precision::Confusion()).Face());
  }
  for (const ProfilePoint& rim : {pieces.front().nurbs().poles.front(), pieces.back().nurbs().poles.back()}) {
    if (rim.x() > 0.0 && !profile.isClosed()) sewing.Add(discOf(rim));
  }
  sewing.Perform(range);
  const TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL);
  if (!shells.More()) return libraryError("the faces do not join");
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shells.Current())).Solid();
  if (!BRepLib::OrientClosedSolid(solid)) return libraryError("the faces do not close");
  return solid;
}

Handle(TCollection_HAsciiString) text(const char* value) {
  return new TCollection_HAsciiString(value);
}

Result<std::string> encode(const TopoDS_Solid& solid, const Message_ProgressRange& range) {
  STEPControl_Writer writer;  // makes the settings known
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  Interface_Static::SetCVal("write.step.product.name", "workpiece");
  if (writer.Transfer(solid, STEPControl_ManifoldSolidBrep, Standard_True, range) != IFSelect_RetDone) {
    return libraryError("the solid cannot be translated");
  }
  const Handle(StepData_StepModel) model = writer.Model();
  APIHeaderSection_MakeHeader header(model);
  header.SetName(text("workpiece"));
  header.SetAuthorValue(1, text(""));
  header.SetOrganizationValue(1, text(""));
  header.SetOriginatingSystem(text("Handwheel"));
  header.SetPreprocessorVersion(text("Handwheel"));
  header.SetDescriptionValue(1, text("turned part"));

  StepData_StepWriter encoder(model);
  encoder.FloatWriter().SetFormat("%.16E");
  encoder.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ostringstream stream;
  if (!encoder.Print(stream)) return libraryError("the file cannot be written");
  return stream.str();
}

StepFileReport measure(const TopoDS_Shape& shape) {
  StepFileReport report;
  for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next()) ++report.solids;
  report.isValid = BRepCheck_Analyzer(shape).IsValid();
  GProp_GProps volume, area;
  BRepGProp::VolumeProperties(shape, volume, tolerance::kQuadrature);
  BRepGProp::SurfaceProperties(shape, area, tolerance::kQuadrature);
  report.volume = volume.Mass();
  report.area = area.Mass();
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  if (!box.IsVoid()) {
    double low[3], high[3];
    box.Get(low[0], low[1], low[2], high[0], high[1], high[2]);
    report.bounds = Box(Vec3(low), Vec3(high));
  }
  return report;
}

Result<std::string> writeSolid(const ProfileCurve& profile, Progress progress) {
  return withLibrary([&]() -> Result<std::string> {
    const Handle(Indicator) indicator = new Indicator(progress);
    Message_ProgressScope scope(indicator->Start(), nullptr, 2);
    const Result<TopoDS_Solid> solid = solidOf(profile, scope.Next());
    if (progress.cancelled()) return cancelledError();
    if (!solid) return solid.error();
    Result<std::string> bytes = encode(*solid, scope.Next());
    if (progress.cancelled()) return cancelledError();
    return bytes;
  });
}

Result<StepFileReport> inspectSolids(std::string_view bytes, Progress progress) {
  return withLibrary([&]() -> Result<StepFileReport> {
    std::istringstream stream{std::string(bytes)};
    STEPControl_Reader reader;
    if (reader.ReadStream("workpiece", stream) != IFSelect_RetDone) return libraryError("it is not a STEP file");
    const Handle(Indicator) indicator = new Indicator(progress);
    reader.TransferRoots(indicator->Start());
    if (progress.cancelled()) return cancelledError();
    const TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull()) return libraryError("the file contains no shape");
    return measure(shape);
  });
}

constexpr StepFunctions kFunctions{writeSolid, inspectSolids};

}  // namespace

}  // namespace handwheel

const handwheel::StepFunctions* handwheelStepFunctions() {
  return &handwheel::kFunctions;
}
