// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include "BuildPaths.h"
#include "TestClass.h"

// The plugin's transport with the real hidapi, on a SpaceMouse Compact that umockdev pretends is plugged in.
class HidrawTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  QString put(const QString& name, const QByteArray& content) const {
    QFile file(m_folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) qFatal("cannot write");
    return file.fileName();
  }

  // Multi-axis controller: report 1 with X, Y, Z, report 2 with Rx, Ry, Rz, report 3 with two buttons, report 4 with
  // the lamp.
  static QByteArray descriptor() {
    return QByteArray::fromHex(
        "05010908a101"
        "a100850116a2fe265e013688fa4678050930093109327510950381 06c0"
        "a10085020933093409358106c0"
        "a102850305091901290215002501350045017501950281 02950e8103c0"
        "a10285040508094b150025017501950191029507 9103c0"
        "c0");
  }

  // Returns the device, its interface, the HID device and the node, in the form that the kernel shows them.
  QByteArray tree() const {
    const QByteArray usb = "/devices/pci0000:00/0000:00:14.0/usb1/1-1";
    const QByteArray interface = usb + "/1-1:1.0", hid = interface + "/0003:256F:C635.0001";
    return "P: " + hid +
           "/hidraw/hidraw0\nN: hidraw0\nE: DEVNAME=/dev/hidraw0\nE: SUBSYSTEM=hidraw\nL: "
           "device=../../../0003:256F:C635.0001\nA: dev=240:0\n\nP: " +
           hid +
           "\nE: SUBSYSTEM=hid\nE: HID_ID=0003:0000256F:0000C635\nE: HID_NAME=3Dconnexion SpaceMouse Compact\n"
           "E: HID_UNIQ=\nH: report_descriptor=" +
           descriptor().toHex().toUpper() + "\n\nP: " + interface +
           "\nE: DEVTYPE=usb_interface\nE: SUBSYSTEM=usb\nA: bInterfaceNumber=00\n\nP: " + usb +
           "\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\nA: idVendor=256f\nA: idProduct=c635\nA: bcdDevice=0437\n"
           "A: manufacturer=3Dconnexion\nA: product=SpaceMouse Compact\nA: serial=\nA: busnum=1\nA: devnum=2\n";
  }

  static QByteArray littleEndian(int number) {
    QByteArray bytes(4, 0);
    for (int i = 0; i < 4; ++i) bytes[i] = static_cast<char>(number >> 8 * i & 0xff);
    return bytes;
  }

  static QByteArray ioctls() {
    const QByteArray size = littleEndian(static_cast<int>(descriptor().size()));
    QByteArray content = descriptor();
    content.resize(4096, 0);
    return "HIDIOCGRDESCSIZE 0 " + size.toHex().toUpper() + "\nHIDIOCGRDESC 0 " + (size + content).toHex().toUpper() +
           "\n";
  }

 private slots:
  void throughTheRealLibrary() {
    const QString umockdev = QStandardPaths::findExecutable("umockdev-run");
    if (umockdev.isEmpty()) QSKIP("umockdev-run is missing (package umockdev)");
    // The lamp, captured reports with time between them, a button. "^X" is a control character.
    const QByteArray script =
        "w 0 ^D^A\n"
        "r 50 ^A^M^@^@^@%^A\n"
        "r 200 ^B^]^@^@^@^[^@\n"
        "r 200 ^A^@^@^@^@^@^@\n"
        "r 200 ^B^@^@^@^@^@^@\n"
        "r 200 ^C^B^@\n";
    QProcess process;
    process.start(umockdev, {"-d", put("mouse.umockdev", tree()), "-i", "/dev/hidraw0=" + put("mouse.ioctl", ioctls()),
                             "-s", "/dev/hidraw0=" + put("mouse.script", script), "--",
                             handwheel::test::buildPath("tests/HidrawProbe")});
    QVERIFY(process.waitForFinished(60000));
    const QByteArray errors = process.readAllStandardError();
    const QList<QByteArray> lines = process.readAllStandardOutput().trimmed().split('\n');
    QVERIFY2(process.exitCode() == 0, QByteArray::number(process.exitCode()) + ": " + errors);
    // 13, 0, 293 of 350 in X, Y, Z are 0.052, -1.172, 0 mm in x, y, z; 29, 0, 27 of 350 rad are 0.0829, -0.0771, 0.
    const QList<QByteArray> expected = {"/dev/hidraw0, SpaceMouse Compact, 2",
                                        "0.0520 -1.1720 0.0000, 0.0000 0.0000 0.0000, 0",
                                        "0.0520 -1.1720 0.0000, 0.0829 -0.0771 0.0000, 0",
                                        "0.0000 0.0000 0.0000, 0.0829 -0.0771 0.0000, 0",
                                        "0.0000 0.0000 0.0000, 0.0000 0.0000 0.0000, 0",
                                        "0.0000 0.0000 0.0000, 0.0000 0.0000 0.0000, 2"};
    QCOMPARE(lines, expected);
  }
};

HANDWHEEL_TEST(HidrawTest)
#include "HidrawTest.moc"
