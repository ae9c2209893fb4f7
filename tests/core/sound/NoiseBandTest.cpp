// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sound/NoiseBand.h"

#include "Spectrum.h"
#include "TestClass.h"

using namespace handwheel;
using namespace handwheel::test;

class NoiseBandTest : public QObject {
  Q_OBJECT

 private slots:
  void hasItsBand_data();
  void hasItsBand();
  void staysStableWhileItMoves();
};

namespace {

constexpr double kBandRate = 48000.0;

std::vector<double> samplesOf(NoiseBand& noise, std::size_t count) {
  std::vector<double> samples(count);
  for (double& s : samples) s = noise.next();
  return samples;
}

}  // namespace

void NoiseBandTest::hasItsBand_data() {
  QTest::addColumn<double>("centre");
  QTest::addColumn<double>("quality");
  QTest::newRow("low") << 300.0 << 4.0;
  QTest::newRow("middle") << 2500.0 << 2.5;
  QTest::newRow("high, broad") << 9000.0 << 1.0;
}

// A standard deviation of 1, whatever the band; and the response of the filter, |H(x)|² = 1 / (1 + Q² (x - 1/x)²) with
// x = tan(πf/rate) / tan(π·centre/rate).
void NoiseBandTest::hasItsBand() {
  QFETCH(double, centre);
  QFETCH(double, quality);
  NoiseBand noise(kBandRate);
  noise.setBand(centre, quality);
  const std::vector<double> samples = samplesOf(noise, 1 << 19);
  const double deviation = rootMeanSquare(samples);
  QVERIFY2(std::abs(deviation - 1.0) < 0.03, qPrintable(QString::number(deviation)));
  const Spectrum spectrum(samples, kBandRate);
  const auto expected = [&](double f) {
    const double x = std::tan(std::numbers::pi * f / kBandRate) / std::tan(std::numbers::pi * centre / kBandRate);
    return 1.0 / (1.0 + std::pow(quality * (x - 1.0 / x), 2));
  };
  const auto measured = [&](double f) { return spectrum.power(0.95 * f, 1.05 * f) / (0.1 * f); };
  for (double share : {0.3, 0.6, 1.7}) {
    const double ratio = measured(share * centre) / measured(centre);
    const double wanted = expected(share * centre) / expected(centre);
    QVERIFY2(std::abs(ratio / wanted - 1.0) < 0.25, qPrintable(QStringLiteral("%1 %2").arg(ratio).arg(wanted)));
  }
}

void NoiseBandTest::staysStableWhileItMoves() {
  NoiseBand noise(kBandRate);
  for (int i = 0; i < 200000; ++i) {
    if (i % 7 == 0) noise.setBand(i % 2 ? 50.0 : 20000.0, i % 3 ? 0.5 : 20.0);
    QVERIFY(std::abs(noise.next()) < 1e3);
  }
  noise.setBand(1e9, 0.0);
  QVERIFY(std::isfinite(noise.next()));
  noise.setBand(-1.0, -1.0);
  QVERIFY(std::isfinite(noise.next()));
}

HANDWHEEL_TEST(NoiseBandTest)
#include "NoiseBandTest.moc"
