// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/ForceCsv.h"

#include "TestClass.h"
#include "machining/force/ForceErrors.h"

#include <QFile>
#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

std::string fileIn(const QString& data, const char* name) {
  QFile file(data + "/lathe/" + name);
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

}  // namespace

// Tables of measured cuts.
class ForceCsvTest : public QObject {
  Q_OBJECT

 private slots:
  void readsAPlainTable() {
    const auto table = forceSamplesFromCsv("ap,f,v,Fc\n1,0.2,100,500\r\n1,0.2,100,500\n\n2,0.1, 90 ,\"550.5\"\n");
    QVERIFY(table);
    QCOMPARE(table->rows, std::size_t(3));
    QCOMPARE(table->samples.size(), std::size_t(2));  // the second is the first once more
    QCOMPARE(table->samples[1], (ForceSample{{2.0, 0.1, 90.0}, 550.5}));
  }

  // A column f beside a column F; worn rows and rows with gaps are counted and left out.
  void readsAPublishedTable() {
    const auto table = forceSamplesFromCsv(
        "Run_ID,TCond,ap,vc,f,Fx,Fy,Fz,F\na,0,0.25,350,0.07,49.2,44.5,21.1,69.6\nb,0.1,0.25,350,0.07,60,44,21,70\n"
        "c,0,0.5,350,0.07,na,44,21,70\n");
    QVERIFY(table);
    QCOMPARE(table->wornRows, std::size_t(1));
    QCOMPARE(table->gapRows, std::size_t(1));
    QCOMPARE(table->samples, (std::vector<ForceSample>{{{0.25, 0.07, 350.0}, 49.2}}));
  }

  // Exact names come first: F is a force beside the feed, and VC, which no name is, stands for vc.
  void aFeedBesideAForce() {
    const auto table = forceSamplesFromCsv("ap,feed,VC,Fc,F\n1,0.2,100,500,700\n");
    QVERIFY(table);
    QCOMPARE(table->samples, (std::vector<ForceSample>{{{1.0, 0.2, 100.0}, 500.0}}));
  }

  // An area by the feed is a depth, r/min and a diameter are a speed.
  void readsATableOfSpindleSpeeds() {
    const std::string text = "Ensayo,rpm,f,f_cal,A0,A_cal,Fx,Fy,Fz\n1,1000,0.104,0.098,0.104,0.098,100.5,78.2,212.6\n";
    QVERIFY(!forceSamplesFromCsv(text));
    QVERIFY(forceSamplesFromCsv(text).error().code == ForceErrors::DiameterNeeded);
    const auto table = forceSamplesFromCsv(text, 100.0);
    QVERIFY(table && table->samples.size() == 1);
    const ForceSample& sample = table->samples[0];
    QVERIFY(std::abs(sample.cut.depth - 1.0) < 1e-12 && sample.cut.feed == 0.098 && sample.force == 212.6);
    QVERIFY(std::abs(sample.cut.speed - 100.0 * M_PI) < 1e-9);
  }

  // RFC 4180: a quote within quotes is written twice; a comma there is none between fields.
  void quotesWithinQuotes() {
    const auto table = forceSamplesFromCsv("\"a \"\"b\"\", c\",ap,f,v,Fc\n\"x,\"\"y\"\"\",1,0.2,100,500\n");
    QVERIFY(table.hasValue());
    QCOMPARE(table->samples, (std::vector<ForceSample>{{{1.0, 0.2, 100.0}, 500.0}}));
  }

  void refusesWithTheLine_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::addColumn<QByteArray>("id");
    QTest::newRow("empty") << QByteArray(" \n\n") << 0 << QByteArray("FileEmpty");
    QTest::newRow("no force") << QByteArray("ap,f,v\n1,1,1\n") << 1 << QByteArray("ColumnMissing");
    QTest::newRow("twice") << QByteArray("ap,ap,f,v,Fc\n1,1,1,1,1\n") << 1 << QByteArray("ColumnTwice");
    QTest::newRow("word") << QByteArray("ap,f,v,Fc\n1,1,1,1\n1,one,1,1\n") << 3 << QByteArray("NumberMalformed");
    QTest::newRow("infinite") << QByteArray("ap,f,v,Fc\n1,1,inf,1\n") << 2 << QByteArray("NumberNotFinite");
    QTest::newRow("negative") << QByteArray("ap,f,v,Fc\n-1,1,1,1\n") << 2 << QByteArray("ValueOutOfRange");
    QTest::newRow("zero force") << QByteArray("ap,f,v,Fc\n1,1,1,0\n") << 2 << QByteArray("ValueOutOfRange");
  }
  void refusesWithTheLine() {
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    QFETCH(QByteArray, id);
    const auto table = forceSamplesFromCsv(text.toStdString());
    QVERIFY(!table);
    QCOMPARE(QByteArray(table.error().code->id), id);
    QCOMPARE(static_cast<int>(table.error().position.value), line);
  }

  void refusesTooManyRows() {
    std::string text = "ap,f,v,Fc\n";
    for (std::size_t i = 0; i <= kMostForceRows; ++i) text += "1,1,1,1\n";
    const auto table = forceSamplesFromCsv(text);
    QVERIFY(!table && table.error().code == ErrorCode::FileTooLarge);
  }

  // 324 and 288 rows; without those of a worn tool 54 and 16 cuts at 31 conditions.
  void readsTheMeasuredSets() {
    const QString data = qEnvironmentVariable("HANDWHEEL_DATA");
    if (data.isEmpty()) QSKIP("HANDWHEEL_DATA is not set: no measured cuts");
    const auto first = forceSamplesFromCsv(fileIn(data, "turning-roughness-forces/Exp1.csv"));
    const auto second = forceSamplesFromCsv(fileIn(data, "turning-roughness-forces/Exp2.csv"));
    QVERIFY(first && second);
    QCOMPARE(first->rows, std::size_t(324));
    QCOMPARE(first->samples.size(), std::size_t(54));
    QCOMPARE(second->rows, std::size_t(288));
    QCOMPARE(second->samples.size(), std::size_t(16));
    // A published fit to the first: 2121.9 ap^1.037 f^0.765 v^-0.040.
    const PowerLaw law = fittedPowerLaw(first->samples);
    QVERIFY(std::abs(std::exp(law.logC) / 2121.9 - 1.0) < 1e-3);
    QVERIFY(std::abs(law.x - 1.037) < 1e-3 && std::abs(law.y - 0.765) < 1e-3 && std::abs(law.n + 0.040) < 1e-3);
    QVERIFY(!forceSamplesFromCsv(fileIn(data, "turning-roughness-forces/Prep.csv")));  // it has no forces
    for (const char* name : {"turning-forces/Ks/Datos.csv", "turning-forces/Ks/DATA/Datos_v4.csv",
                             "turning-forces/Ks/DATA/Datos_v5.csv"}) {
      const auto table = forceSamplesFromCsv(fileIn(data, name), 60.0);
      QVERIFY2(table && table->samples.size() == 4, name);
      for (const ForceSample& sample : table->samples) QVERIFY(std::abs(sample.cut.depth - 1.0) < 1e-9);
      QCOMPARE(table->samples[0].force, 212.562);
    }
  }
};

HANDWHEEL_TEST(ForceCsvTest)
#include "ForceCsvTest.moc"
