// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/device/DeviceErrors.h"
#include "io/FileStream.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>
#include <QTemporaryDir>
#include <QtTest>

using namespace handwheel;

class FileStreamTest : public QObject {
  Q_OBJECT

 private slots:
  void carriesBytesBothWaysAndSeesTheEnd() {
    int ends[2];
    QCOMPARE(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends), 0);
    FileStream stream(ends[0]);
    std::uint8_t buffer[8] = {};
    QCOMPARE(stream.read(buffer, 0.0), std::ptrdiff_t(0));
    QCOMPARE(::write(ends[1], "abc", 3), ssize_t(3));
    QCOMPARE(stream.read(buffer, 1.0), std::ptrdiff_t(3));
    QCOMPARE(buffer[2], std::uint8_t('c'));
    QVERIFY(stream.write(std::span(buffer).first(2)));
    char back[8] = {};
    QCOMPARE(::read(ends[1], back, sizeof(back)), ssize_t(2));
    ::close(ends[1]);
    QCOMPARE(stream.read(buffer, 1.0), kGone);
    QVERIFY(!stream.write(buffer));  // and no signal ends the program
  }

  // The line is raw: control characters go through as they are, and nothing comes back as an echo.
  void aSerialLineIsRaw() {
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
    QVERIFY(master >= 0 && ::grantpt(master) == 0 && ::unlockpt(master) == 0);
    auto stream = openSerial(::ptsname(master));
    QVERIFY(stream.hasValue());
    const std::uint8_t sent[] = {3, 4, 10, 13, 17, 255};
    QCOMPARE(::write(master, sent, sizeof(sent)), ssize_t(sizeof(sent)));
    std::uint8_t buffer[16] = {};
    QCOMPARE((*stream)->read(buffer, 1.0), std::ptrdiff_t(sizeof(sent)));
    QVERIFY(std::equal(std::begin(sent), std::end(sent), buffer));
    QVERIFY((*stream)->write(sent));
    std::uint8_t seen[16] = {};
    QCOMPARE(::read(master, seen, sizeof(seen)), ssize_t(sizeof(sent)));
    QVERIFY(std::equal(std::begin(sent), std::end(sent), seen));
    ::close(master);
    QCOMPARE((*stream)->read(buffer, 1.0), kGone);
  }

  void whatIsNotThereIsAnError() {
    const QTemporaryDir folder;
    const std::string nothing = folder.filePath("nothing").toStdString();
    QCOMPARE(connectUnix(nothing).error().code, DeviceError::Unreachable);
    QCOMPARE(connectUnix(std::string(500, 'x')).error().code, DeviceError::Unreachable);
    QCOMPARE(openSerial(nothing).error().code, DeviceError::Unreachable);
    QCOMPARE(openSerial("/dev/null").error().code, DeviceError::Unreachable);  // no serial line
    QCOMPARE(connectLoopback(1).error().code, DeviceError::Unreachable);
  }
};

HANDWHEEL_TEST(FileStreamTest)
#include "FileStreamTest.moc"
