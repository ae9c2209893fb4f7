// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "Program.h"
#include "Shapes.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;

class CommandLineTest : public QObject {
  Q_OBJECT

 private slots:
  void help() {
    const Fixture fixture;
    const Ran overview = fixture.run({"--help"});
    QCOMPARE(overview.code, 0);
    QCOMPARE(overview.err, QByteArray());
    for (const char* command : {"inspect",  "repair",   "convert",
                                "picture",  "new",      "set",
                                "measure",  "compare",  "decimate",
                                "split",    "merge",    "section",
                                "devices",  "feel",     "edit",
                                "turn",     "body",     "recording",
                                "exercise", "mark",     "program",
                                "target",   "train",    "force",
                                "thread",   "ik",       "benchmark-planning",
                                "plan",     "verify",   "configuration",
                                "post",     "teleop",   "optimise-path",
                                "robot",    "voxelize", "remesh",
                                "boolean",  "shell",    "offset",
                                "debris",   "gaps",     "smooth",
                                "clay",     "drill",    "drill-experiments",
                                "segment"}) {
      QVERIFY(overview.out.contains(QByteArray("\n  ") + command + " "));
      const Ran page = fixture.run({"help", command});
      QStringList options;  // no two of one name
      for (const QByteArray& line : page.out.split('\n')) {
        const QString option = QString::fromUtf8(line).section(QStringLiteral("--"), 1, 1).section(' ', 0, 0);
        if (line.startsWith("  ") && line.left(8).contains("--")) options << option;
      }
      options.sort();
      QCOMPARE(options.removeDuplicates(), 0);
      QCOMPARE(page.code, 0);
      QVERIFY(page.out.startsWith(QByteArray("Usage: handwheel ") + command + " "));
      QCOMPARE(fixture.run({command, "--help"}).out, page.out);
    }
    QCOMPARE(fixture.run({"help"}).out, overview.out);
    // Whole sentences: a point within a word, as in ".stl" and "25.4", ends none.
    const QString table = QString(overview.out).section("Commands:\n", 1).section("\n\n", 0, 0) + '\n';
    const QRegularExpression command("^  [a-z-]+ ", QRegularExpression::MultilineOption);
    const QRegularExpression entry("^  [a-z-]+ +[A-Z][A-Za-z ,;:().'\n-]*?\\.$(?!\\n   )",
                                   QRegularExpression::MultilineOption);
    QCOMPARE(table.count(command), 48);
    QCOMPARE(table.count(entry), 48);
    // The map for newcomers names each of them.
    QFile map(test::sourcePath("ARCHITECTURE.md"));
    QVERIFY(map.open(QIODevice::ReadOnly));
    const QString known = QString(map.readAll()).section("subcommands: ", 1).section('\n', 0, 0) + ',';
    for (auto match = command.globalMatch(table); match.hasNext();) {
      const QString name = match.next().captured().trimmed();
      QVERIFY2(known.contains(QRegularExpression("(^|, )" + name + "( \\(|,)")), qPrintable(name));
    }
    for (const QString& line : table.split('\n', Qt::SkipEmptyParts))
      QVERIFY2(line.startsWith(QString(22, ' ')) || command.match(line).hasMatch(), qPrintable(line));
    for (const char* option :
         {"-o", "--fill", "--continuity", "--keep-open", "--open-sheets", "--max-hole", "--remove-debris",
          "--keep-folded-regions", "--unit", "--partial", "--report", "--screenshot"}) {
      QVERIFY2(fixture.run({"help", "repair"}).out.contains(option), option);
    }
  }

  void version() {
    const Ran ran = Fixture().run({"--version"});
    QCOMPARE(ran.code, 0);
    QVERIFY(QRegularExpression("^Handwheel \\d+\\.\\d+\\.\\d+\\n$").match(ran.out).hasMatch());
  }

  void mistakes_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const QStringList& words, const char* sentence, const char* help) {
      QTest::newRow(qPrintable(words.join(' ')))
          << words << QByteArray("handwheel: ") + sentence + "\nTry 'handwheel help" + help + "'.\n";
    };
    row({"--wibble"}, "There is no option --wibble.", "");
    row({"wibble", "a.stl"}, "There is no command or file wibble.", "");
    row({"help", "wibble"}, "There is no command wibble.", "");
    row({"inspect"}, "The command inspect needs IN.", " inspect");
    row({"inspect", "a.stl", "b.stl"}, "The command inspect takes no more than IN.", " inspect");
    row({"inspect", "a.stl", "--jsn"}, "There is no option --jsn.", " inspect");
    row({"inspect", "a.stl", "--json=1"}, "The option --json takes no value.", " inspect");
    row({"repair", "a.stl"}, "The option -o OUT is missing.", " repair");
    row({"repair", "a.stl", "-o"}, "The option -o needs a value: OUT.", " repair");
    row({"repair", "a.stl", "-o", "b.stl", "-x"}, "There is no option -x.", " repair");
    row({"repair", "a.stl", "-o", "b.stl", "--fill", "x"},
        "--fill takes fair, refined, ear, minimal, area, dihedral, ridge or flat, not 'x'.", " repair");
    row({"repair", "a.stl", "-o", "b.stl", "--continuity", "x"},
        "--continuity takes position, tangent or curvature, not 'x'.", " repair");
    row({"repair", "a.stl", "-o", "b.stl", "--keep-open", "1,"}, "--keep-open takes loop numbers separated by commas.",
        " repair");
    row({"repair", "a.stl", "-o", "b.stl", "--max-hole", "-3"},
        "--max-hole takes a whole number from 0 to 4294967295, not '-3'.", " repair");
    row({"repair", "a.stl", "-o", "b.stl", "--unit", "ft"}, "--unit takes mm, cm, m or in.", " repair");
    row({"repair", "a.stl", "-o", "b.stl", "--report", "./b.stl"},
        "IN and OUT cannot be the report or the screenshot too: ./b.stl.", " repair");
    row({"repair", "a.stl", "-o", "b.stl", "--screenshot", "a.stl"},
        "IN and OUT cannot be the report or the screenshot too: a.stl.", " repair");
    row({"repair", "a.stl", "-o", "b.stl", "--report", "r", "--screenshot", "r"},
        "The report and the screenshot need a file each.", " repair");
    for (const char* document : {"c.handwheel", "c.STL", "c.step", "c.urdf"})
      row({"repair", "a.stl", "-o", "b.stl", "--report", document},
          "--report takes a name such as part.json, not that of a document.", " repair");
    row({"repair", "a.stl", "-o", "b.stl", "--screenshot", "c.handwheel"},
        "--screenshot takes a name that ends in .png.", " repair");
    row({"measure", "--csv", "c.handwheel"}, "--csv takes a name such as curves.csv, not that of a document.",
        " measure");
    row({"picture", "a.stl", "a.stl"}, "PNG is a name that ends in .png.", " picture");
    row({"repair", "a.stl", "-o", ""}, "The option -o needs a value: OUT.", " repair");
    row({"repair", "a.stl", "--output="}, "The option --output needs a value: OUT.", " repair");
    row({"set", "a.stl"}, "The option -o OUT is missing.", " set");
    row({"new", "castle", "-o", "b.handwheel"}, "KIND is exercise or volume or workpiece, not 'castle'.", " new");
    row({"convert", "a.stl"}, "The command convert needs IN OUT.", " convert");
  }
  void mistakes() {
    QFETCH(QStringList, words);
    QFETCH(QByteArray, message);
    const Ran ran = Fixture().run(words);
    QCOMPARE(ran.code, 1);
    QCOMPARE(ran.out, QByteArray());
    QCOMPARE(ran.err, message);
  }

  void optionsInEveryForm() {
    for (const QStringList& output :
         {QStringList{"-o", "b.off"}, {"-ob.off"}, {"--output", "b.off"}, {"--output=b.off"}}) {
      const Fixture fixture;
      fixture.put("a.off", cube().off());
      QCOMPARE(fixture.run(QStringList{"repair"} + output + QStringList{"a.off"}).code, 0);
      QCOMPARE(fixture.names(), (QStringList{"a.off", "b.off"}));
    }
  }

  // No file that the program opens reuses the descriptor of its closed output.
  void closedOutputIsAnError() {
    const Fixture fixture;
    fixture.put("a.off", cube().off());
    QProcess process;
    process.setWorkingDirectory(fixture.path());
    process.start("sh", {"-c", QString("exec '%1' inspect a.off 0<&- 1>&-").arg(test::programPath())});
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitCode(), 1);
    QCOMPARE(process.readAllStandardError(),
             QByteArray("handwheel: The output could not be written (Bad file descriptor).\n"));
  }

  // Redirected to a full disk, the figures are not lost silently.
  void fullOutputIsAnError() {
    if (!QFile::exists("/dev/full")) QSKIP("there is no /dev/full");
    const Fixture fixture;
    fixture.put("a.off", cube().off());
    QProcess process;
    process.setStandardOutputFile("/dev/full");
    process.start(test::programPath(), {"inspect", fixture.path() + "/a.off"});
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().contains("No space left on device"));
  }
};

HANDWHEEL_TEST(CommandLineTest)
#include "CommandLineTest.moc"
