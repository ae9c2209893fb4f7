// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReadDescription.h"
#include "TestClass.h"

#include <QDirIterator>
#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

// Real meshes, and files with damage that users report. They are not part of the sources: the folder named by
// HANDWHEEL_DATA holds them under "scans". Expectations come from other readers and from looking at the files.
namespace {

struct Scan {
  const char* file;
  std::size_t triangles;
};

// Counted by a program that shares no code with this one (polygons as fans).
constexpr Scan kScans[] = {
    {"admesh/conveyor.stl", 799},
    {"admesh/fill-holes-bad.stl", 855},
    {"assimp/Wuson.stl", 3732},
    {"assimp/regr01.obj", 2710},
    {"assimp/sphereWithHole.stl", 285},
    {"common-3d-test-models/alligator.obj", 5981},
    {"common-3d-test-models/beetle-alt.obj", 38656},
    {"common-3d-test-models/beetle.obj", 2053},
    {"common-3d-test-models/ogre.obj", 124008},
    {"common-3d-test-models/stanford-bunny.obj", 69451},
    {"common-3d-test-models/suzanne.obj", 968},
    {"common-3d-test-models/teapot.obj", 6320},
    {"comodo/lego_figure_head.stl", 8105},
    {"comodo/nefertiti_fine.stl", 5716},
    {"geogram-data/SaraPezzini.obj", 3342},
    {"geogram-data/joint.off", 446},
    {"geogram-data/mask3kf.obj", 3000},
    {"geogram-data/three_cubes_3.obj", 36},
    {"geogram-data/three_cylinders.obj", 1188},
    {"geogram-data/tmp_wing_with_isolated_facet.obj", 61},
    {"geometry-central/fan3.obj", 3},
    {"geometry-central/hourglass_ico.obj", 40},
    {"geometry-central/lego.ply", 3072},
    {"geometry-central/triple_vierbein.obj", 108},
    {"libigl-tests/annulus.obj", 9724},
    {"libigl-tests/marching_tets_output.obj", 4926},
    {"libigl-tests/two-boxes-bad-self-union.ply", 708},
    {"libigl-tutorial/camelhead.off", 22704},
    {"libigl-tutorial/cow.off", 5520},
    {"libigl-tutorial/decimated-knight.off", 1000},
    {"libigl-tutorial/fertility.off", 9000},
    {"libigl-tutorial/halftunnel.off", 1568},
    {"libigl-tutorial/inspired_mesh.obj", 4288},
    {"libigl-tutorial/lion.off", 16674},
    {"libigl-tutorial/truck.obj", 4770},
    {"liepa/bunny-1.obj", 4521},
    {"liepa/crenellations.obj", 62},
    {"liepa/sphere-2.obj", 1097},
    {"manifold-tests/Offset1.obj", 4418},
    {"manifold-tests/openscad-nonmanifold-crash.obj", 1442},
    {"manifold-tests/self_intersectA.obj", 17160},
    {"meshlab-rangemaps/lato180.ply", 84635},
    {"meshlab-samples/Laurana50k.ply", 49954},
    {"meshlab-samples/T.ply", 36},
    {"meshlab-samples/bunny10k.ply", 9999},
    {"meshlab-samples/conrod.stl", 6442},
    {"meshlab-samples/elephant.ply", 39290},
    {"meshlab-samples/greek_helmet.obj", 9608},
    {"meshlab-samples/many_small_holes.ply", 3524},
    {"meshlab-samples/non_manif_hole.ply", 755},
    {"meshlab-samples/screwdriver.ply", 13574},
    {"meshlab-samples/sub.obj", 2500},
    {"occt-stl/video_part.stl", 9694},
    {"pmp-data/fairing-cross.off", 9762},
    {"pmp-data/hemisphere.off", 3600},
    {"pymeshfix/StanfordBunny.ply", 99785},
    {"pymeshlab/bone.ply", 3022},
    {"pyvista-vtk-data/42400-IDGH.stl", 11036},
    {"pyvista-vtk-data/InterpolatingOnSTL_final.stl", 5131},
    {"pyvista-vtk-data/greatWhite.stl", 6264},
    {"pyvista-vtk-data/trumpet.obj", 23696},
    {"pyvista-vtk-data/turbineblade.ply", 199034},
    {"thingi10k/112932.stl", 7880},
    {"thingi10k/79741.stl", 14740},
    {"thingi10k/88566.stl", 5344},
    {"trimesh-models/angle_block.STL", 704},
    {"trimesh-models/bunny.ply", 16301},
    {"trimesh-models/busted.STL", 3878},
    {"trimesh-models/chair_model.obj", 12756},
    {"trimesh-models/featuretype.STL", 3476},
    {"trimesh-models/idler_riser.STL", 1572},
    {"trimesh-models/multibody.stl", 32},
    {"trimesh-models/reference.ply", 1610},
    {"trimesh-models/soup.stl", 100},
    {"trimesh-models/teapot.stl", 894},
    {"trimesh-models/wallhole.obj", 66},
    {"webgl-hole-filling/adonis.obj", 19992},
    {"webgl-hole-filling/diana_hole_top.obj", 19379},
    {"webgl-hole-filling/squirrel_sideholes.obj", 21465},
};

struct Malformed {
  const char* file;
  const char* strict;
  const char* partial;
};

constexpr Malformed kMalformed[] = {
    {"admesh-block/exact-bad.stl", "12", "12"},
    {"admesh-block/fill-holes-bad.stl", "11", "11"},
    {"admesh-block/fill-holes-good.stl", "12", "12"},
    {"admesh-block/nearby-bad.stl", "12", "12"},
    {"admesh-block/remove-unconnected-bad.stl", "25", "25"},
    {"assimp/OutOfMemory.off", "DataTruncated(vertices,353535235358,14) line 17", "NothingReadable line 17"},
    {"assimp/box_UTF16BE.obj", "TextEncoding(UTF-16)", "TextEncoding(UTF-16)"},
    {"assimp/box_longline.obj", "944", "944"},
    {"assimp/concave_polygon.obj", "64", "64"},
    {"assimp/cube_binary_header_with_RN_newline.ply", "12", "12"},
    {"assimp/empty.obj", "FileEmpty", "FileEmpty"},
    {"assimp/empty.off", "FileEmpty", "FileEmpty"},
    {"assimp/empty.ply", "FileEmpty", "FileEmpty"},
    {"assimp/float-color.ply", "1", "1"},
    {"assimp/issue623.ply", "TokenUnexpected(a whole number,) line 14", "NothingReadable line 14"},
    {"assimp/malformed.obj", "IndexOutOfRange(0,8) line 28", "8, damage 2"},
    {"assimp/number_formats.obj", "NumberMalformed(3.1+e2) line 11", "1, damage 6"},
    {"assimp/testmixed.obj", "12", "12"},
    {"assimp/triangle_with_empty_solid.stl", "1", "1"},
    {"draco/deg_faces.obj", "4", "4"},
    {"draco/delim_test.ply", "12", "12"},
    {"draco/extra_vertex.obj", "3", "3"},
    {"draco/float_inf_point_cloud.ply", "NumberNotFinite(+inf) line 8", "NothingReadable line 8"},
    {"draco/inf_nan.obj", "NumberNotFinite(inf) line 1", "NothingReadable line 1"},
    {"draco/non_manifold_wrap.obj", "12", "12"},
    {"draco/test_extra_whitespace.ply", "1", "1"},
    {"geogram-data/corrupted_invalid_double.obj", "NumberMalformed(XXX0.5854098561465024) line 6", "3, damage 18"},
    {"geogram-data/corrupted_invalid_double.off", "NumberMalformed(X0.425325) line 4", "15, damage 6"},
    {"geogram-data/corrupted_invalid_face_count.ply", "DataTruncated(faces,22,20) byte 2160", "20, damage 1"},
    {"geogram-data/corrupted_invalid_facet_vertex.obj", "IndexOutOfRange(8,6) line 20", "5, damage 15"},
    {"geogram-data/corrupted_invalid_facet_vertex.off", "IndexOutOfRange(100,12) line 15", "19, damage 1"},
    {"geogram-data/corrupted_invalid_int.off", "TokenUnexpected(a whole number,1X) line 15", "19, damage 1"},
    {"geogram-data/corrupted_invalid_triangle_count.stl", "DataTruncated(facets,22,20) byte 1084", "20, damage 1"},
    {"geogram-data/corrupted_invalid_vertex_count.off", "TokenUnexpected(a whole number,0.309017) line 13",
     "12, damage 9"},
    {"geogram-data/truncated.obj", "TokenUnexpected(a number,) line 9", "NothingReadable line 9"},
    {"geogram-data/truncated.ply", "DataTruncated(vertices,12,6) byte 1828", "NothingReadable byte 1828"},
    {"geogram-data/truncated.stl", "DataTruncated(facets,20,10) byte 584", "10, damage 1"},
    {"mayo/#258_cube.off", "12", "12"},
    {"numpy-stl/CubeInvalidUnicode.stl", "12", "12"},
    {"numpy-stl/Moon_Chinese.stl", "116", "116"},
    {"numpy-stl/StarWithEmptyHeader.stl", "68", "68"},
    {"other/degenerated.obj", "24", "24"},
    {"tinyobjloader/invalid-face-definition.obj", "PolygonTooSmall(1) line 15", "NothingReadable line 15"},
    {"tinyobjloader/invalid-relative-vertex-index.obj", "IndexOutOfRange(-4,0) line 1", "NothingReadable line 1"},
    {"tinyobjloader/issue-140-zero-face-idx.obj", "IndexOutOfRange(0,4) line 16", "1, damage 1"},
    {"tinyobjloader/issue-319-002.obj", "14", "14"},
    {"tinyobjloader/issue-330.obj", "3", "3"},
    {"tinyobjloader/leading-zero-in-exponent-notation-issue-210.obj", "1", "1"},
    {"tinyobjloader/line-prim.obj", "NoTriangles", "NoTriangles"},
    {"tinyobjloader/mtl filename with whitespace issue46.obj", "12", "12"},
    {"tinyobjloader/test-nan.obj", "NumberNotFinite(nan) line 12", "34, damage 5"},
    {"trimesh/empty.obj", "NoTriangles", "NoTriangles"},
    {"trimesh/empty.stl", "NoTriangles", "NoTriangles"},
    {"trimesh/multi.ply", "2", "2"},
    {"trimesh/nancolor.obj", "12", "12"},
    {"trimesh/negative_indices.obj", "12", "12"},
    {"trimesh/notenoughindices.obj", "PolygonTooSmall(2) line 9", "1, damage 1"},
    {"trimesh/obj_empty.obj", "NoTriangles", "NoTriangles"},
    {"trimesh/obj_points.obj", "NoTriangles", "NoTriangles"},
    {"trimesh/ply_empty_ascii.ply", "NoTriangles", "NoTriangles"},
    {"trimesh/ply_empty_bin.ply", "NoTriangles", "NoTriangles"},
    {"trimesh/ply_empty_header.ply", "NoTriangles", "NoTriangles"},
    {"trimesh/points_ascii.ply", "NoTriangles", "NoTriangles"},
    {"trimesh/polygonfaces.obj", "3", "3"},
    {"trimesh/stl_empty_bin.stl", "NoTriangles", "NoTriangles"},
    {"trimesh/two_objects_mixed_case_names.stl", "24", "24"},
    {"trimesh/whitespace.off", "12", "12"},
};

QString scansFolder() {
  const QString data = qEnvironmentVariable("HANDWHEEL_DATA");
  return data.isEmpty() ? QString() : data + "/scans/";
}

// "12", "12, damage 3" or the error.
QString summary(const Result<MeshFile>& file) {
  if (!file) return describe(file.error());
  const QString triangles = QString::number(file->soup.triangles.size());
  return file->damage.empty() ? triangles : triangles + QString(", damage %1").arg(file->damage.size());
}

Result<MeshFile> readScan(const QString& name, bool partial) {
  return readMeshFile((scansFolder() + name).toStdString(), {partial});
}

}  // namespace

class ScanFilesTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    if (scansFolder().isEmpty()) QSKIP("HANDWHEEL_DATA is not set");
    QVERIFY2(QDir(scansFolder()).exists(), qPrintable(scansFolder()));
  }

  void scans_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("expected");
    for (const Scan& scan : kScans) QTest::newRow(scan.file) << scan.file << QString::number(scan.triangles);
  }

  void scans() {
    QFETCH(QString, file);
    QFETCH(QString, expected);
    QCOMPARE(summary(readScan(file, false)), expected);
    QCOMPARE(summary(readScan(file, true)), expected);
  }

  void malformed_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("strict");
    QTest::addColumn<QString>("partial");
    for (const Malformed& row : kMalformed)
      QTest::newRow(row.file) << QString("malformed/") + row.file << row.strict << row.partial;
  }

  void malformed() {
    QFETCH(QString, file);
    QFETCH(QString, strict);
    QFETCH(QString, partial);
    QCOMPARE(summary(readScan(file, false)), strict);
    QCOMPARE(summary(readScan(file, true)), partial);
  }

  // The tables name every file there is.
  void tablesAreComplete() {
    QStringList known;
    for (const Scan& scan : kScans) known << scan.file;
    for (const Malformed& row : kMalformed) known << QString("malformed/") + row.file;
    QStringList found;
    QDirIterator files(scansFolder(), QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      const QString name = QDir(scansFolder()).relativeFilePath(files.next());
      if (formatForName(name.toStdString())) found << name;
    }
    known.sort();
    found.sort();
    QCOMPARE(found, known);
  }
};

HANDWHEEL_TEST(ScanFilesTest)
#include "ScanFilesTest.moc"
