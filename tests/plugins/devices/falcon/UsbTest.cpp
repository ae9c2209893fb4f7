// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include "BuildPaths.h"
#include "TestClass.h"

// The plugin's transport with the real libusb, on a Falcon that umockdev pretends is plugged in. It cannot imitate
// control requests, so the bootloader is left to the model of the device.
class UsbTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  QString put(const QString& name, const QByteArray& content) const {
    QFile file(m_folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) qFatal("cannot write");
    return file.fileName();
  }

  // Device 0403:cb48; one interface with a bulk pipe in (0x81) and one out (0x02), 64 bytes each.
  static QByteArray tree() {
    const QByteArray descriptors =
        "12011001000000080304 48CB000401020301"
        "09022000010100802D09040000 02FFFFFF0207058102400000 07050202400000";
    const QByteArray hex = QByteArray(descriptors).replace(' ', "");
    return "P: /devices/pci0000:00/0000:00:14.0/usb1/1-1\nN: bus/usb/001/003=" + hex +
           "\nE: DEVNAME=/dev/bus/usb/001/003\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\nE: BUSNUM=001\nE: DEVNUM=003\n"
           "E: MAJOR=189\nE: MINOR=2\nE: PRODUCT=403/cb48/400\nA: idVendor=0403\nA: idProduct=cb48\nA: busnum=1\n"
           "A: devnum=3\nA: speed=12\nA: bConfigurationValue=1\nA: bNumConfigurations=1\nH: descriptors=" +
           hex + "\n";
  }

  static QByteArray urb(int pipe, int length, const QByteArray& data) {
    return "USBDEVFS_REAPURBNDELAY 0 3 " + QByteArray::number(pipe) + " 0 0 " + QByteArray::number(length) + " " +
           QByteArray::number(data.size()) + " 0 " + data.toHex().toUpper() + "\n";
  }

 private slots:
  void throughTheRealLibrary() {
    const QString umockdev = QStandardPaths::findExecutable("umockdev-run");
    if (umockdev.isEmpty()) QSKIP("umockdev-run is missing (package umockdev)");
    const QByteArray ioctls = "USBDEVFS_GET_CAPABILITIES 0 0F000000\n " + urb(2, 16, "<AAAAAAAAAAAAAA>") + "  " +
                              urb(129, 64, QByteArray("\x01\x60", 2) + "<JFKPMAAAAAAAqA>");
    QProcess process;
    process.start(umockdev,
                  {"-d", put("falcon.umockdev", tree()), "-i", "/dev/bus/usb/001/003=" + put("falcon.ioctl", ioctls),
                   "--", handwheel::test::buildPath("tests/UsbProbe")});
    QVERIFY(process.waitForFinished(60000));
    const QByteArray errors = process.readAllStandardError();
    const QList<QByteArray> lines = process.readAllStandardOutput().trimmed().split('\n');
    QVERIFY2(process.exitCode() == 0, QByteArray::number(process.exitCode()) + ": " + errors + lines.join('/'));
    // "JFKP" is 9, 5, A, F: 0xFA59, which is -1447; "MAAA" is 12.
    QCOMPARE(lines.last(), QByteArray("1, -1447 12 0"));
    QCOMPARE(lines.size(), 2);
  }
};

HANDWHEEL_TEST(UsbTest)
#include "UsbTest.moc"
