// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/NrrdWriter.h"

#include "ImageBytes.h"
#include "MadeImages.h"
#include "TestClass.h"
#include "volume/image/NrrdReader.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

class NrrdWriterTest : public QObject {
  Q_OBJECT

 private slots:
  // By the format's definition: a header of fields, an empty line, and the numbers.
  void asDefined() {
    const ImageGrid grid{{2, 1, 1}, Vec3(1, 2.5, -3), Vec3(0.5, 1, 2).asDiagonal().toDenseMatrix()};
    const std::string file = nrrdOf(ImageVolume(grid, std::vector<std::int16_t>{258, -2}));
    QVERIFY(
        file.starts_with("NRRD0004\ntype: int16\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 1 1\n"
                         "space directions: (0.5,0,0) (0,1,0) (0,0,2)\n"));
    QVERIFY(file.find("\nendian: little\nencoding: raw\nspace origin: (1,2.5,-3)\n\n") != std::string::npos);
    QVERIFY(file.ends_with(std::string("\n\n\2\1\xfe\xff", 6)));
  }

  void readBack() {
    ImageGrid grid{{7, 5, 3}, Vec3(0.1, -1e5, 3), Eigen::Matrix3d::Identity()};
    grid.steps << 0.3, 0.1, 0.0, 0.0, -0.7, 0.2, 0.0, 0.0, 1.0 / 3.0;
    const ImageVolume image = imageOf(grid, [](const Vec3& p) { return p.x() - 0.1 * p.y() * p.z(); });
    const Result<ImageFile> read = readNrrd(nrrdOf(image), beside({}));
    QVERIFY(read.hasValue());
    QCOMPARE(valuesIn(read->image), valuesIn(image));
    QCOMPARE(read->image.grid().steps, grid.steps);
    QCOMPARE(read->image.grid().origin, grid.origin);
    QVERIFY(read->remarks.empty());
  }
};

HANDWHEEL_TEST(NrrdWriterTest)
#include "NrrdWriterTest.moc"
