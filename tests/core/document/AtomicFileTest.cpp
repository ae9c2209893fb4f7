// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/AtomicFile.h"

#include "TestClass.h"
#include "document/AtomicSaveFile.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <cstring>

using namespace handwheel;

namespace {

std::filesystem::path in(const QTemporaryDir& folder, const char* name) {
  return folder.filePath(name).toStdString();
}

QByteArray contentOf(const std::filesystem::path& path) {
  QFile file(QString::fromStdString(path.string()));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be opened");
}

QStringList namesIn(const QTemporaryDir& folder) {
  return QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
}

std::string reasonOf(const Status& status) {
  return status || status.error().code != ErrorCode::WriteFailed ? "no WriteFailed" : status.error().arguments.at(0);
}

}  // namespace

class AtomicFileTest : public QObject {
  Q_OBJECT

 private slots:
  void writesAndReplaces() {
    QTemporaryDir folder;
    const std::string large(3 << 20, 'x');  // several blocks
    QVERIFY(writeFileAtomically(in(folder, "a"), large).hasValue());
    QCOMPARE(contentOf(in(folder, "a")).toStdString(), large);
    QVERIFY(writeFileAtomically(in(folder, "a"), std::string_view("\0b", 2)).hasValue());
    QCOMPARE(contentOf(in(folder, "a")), QByteArray("\0b", 2));
    QCOMPARE(namesIn(folder), QStringList{"a"});
  }

  void replacesSeveral() {
    QTemporaryDir folder;
    QVERIFY(writeFileAtomically(in(folder, "a"), "old").hasValue());
    const FileContent both[] = {{in(folder, "a"), "new"}, {in(folder, "b"), "also new"}};
    QVERIFY(writeFilesAtomically(both).hasValue());
    QCOMPARE(contentOf(in(folder, "a")), QByteArray("new"));
    QCOMPARE(contentOf(in(folder, "b")), QByteArray("also new"));
  }

  // An obstacle to one of them is found before any is replaced.
  void replacesAllOrNone() {
    QTemporaryDir folder;
    QVERIFY(writeFileAtomically(in(folder, "a"), "old").hasValue());
    const FileContent both[] = {{in(folder, "a"), "new"}, {in(folder, "no/such/b"), "new"}};
    QCOMPARE(reasonOf(writeFilesAtomically(both)), std::string(std::strerror(ENOENT)));
    QCOMPARE(contentOf(in(folder, "a")), QByteArray("old"));
    QCOMPARE(namesIn(folder), QStringList{"a"});
  }

  // A program that is about to end cancels first and then asks if a file is being written.
  void cancelledBeforeItBegins() {
    QTemporaryDir folder;
    JobState state;
    state.cancelled = true;
    const Status status = writeFileAtomically(in(folder, "a"), "", Progress(state));
    QVERIFY(!status.hasValue());
    QCOMPARE(status.error().code, ErrorCode::Cancelled);
    QVERIFY(!isWritingFile());
    QVERIFY(namesIn(folder).isEmpty());
  }

  void keepsPermissions() {
    QTemporaryDir folder;
    QVERIFY(writeFileAtomically(in(folder, "a"), "old").hasValue());
    QCOMPARE(chmod(in(folder, "a").c_str(), 0640), 0);
    QVERIFY(writeFileAtomically(in(folder, "a"), "new").hasValue());
    struct stat status {};
    QCOMPARE(stat(in(folder, "a").c_str(), &status), 0);
    QCOMPARE(status.st_mode & 0777u, 0640u);
  }

  void writesThroughLinks() {
    QTemporaryDir folder;
    QDir(folder.path()).mkdir("elsewhere");
    const auto target = in(folder, "elsewhere/target");
    std::filesystem::create_symlink("elsewhere/target", in(folder, "link"));
    QVERIFY(writeFileAtomically(in(folder, "link"), "first").hasValue());  // the target does not exist yet
    QCOMPARE(contentOf(target), QByteArray("first"));
    QVERIFY(writeFileAtomically(in(folder, "link"), "second").hasValue());
    QCOMPARE(contentOf(target), QByteArray("second"));
    QVERIFY(std::filesystem::is_symlink(in(folder, "link")));
    // Over several links, and in a ring.
    std::filesystem::create_symlink(in(folder, "link"), in(folder, "further"));
    QVERIFY(writeFileAtomically(in(folder, "further"), "third").hasValue());
    QCOMPARE(contentOf(target), QByteArray("third"));
    std::filesystem::create_symlink("ring", in(folder, "ring"));
    QCOMPARE(reasonOf(writeFileAtomically(in(folder, "ring"), "x")), std::string(std::strerror(ELOOP)));
    QCOMPARE(namesIn(folder), (QStringList{"elsewhere", "further", "link", "ring"}));
  }

  void namesAreBytes() {
    QTemporaryDir folder;
    const std::filesystem::path path = in(folder, "a\xff\xfe.handwheel");
    QVERIFY(writeFileAtomically(path, "first").hasValue());
    QVERIFY(writeFileAtomically(path, "second").hasValue());
    QVERIFY(std::filesystem::file_size(path) == 6);
    const std::filesystem::path longest = in(folder, std::string(255, 'x').c_str());
    QVERIFY(writeFileAtomically(longest, "first").hasValue());
    QVERIFY(writeFileAtomically(longest, "second").hasValue());
    QCOMPARE(contentOf(longest), QByteArray("second"));
  }

  // Killed at any moment of many writes. Only while the complete file has a name besides the one it takes there is
  // another, hidden one; the next write removes it.
  void killedItLeavesTheOldOrTheNewFileAndNothingElse() {
    QTemporaryDir folder;
    const auto path = in(folder, "a");
    const std::string contents[] = {std::string(3 << 20, 'x'), std::string(5 << 20, 'y')};
    QVERIFY(writeFileAtomically(path, contents[0]).hasValue());
    for (int i = 0; i < 20; ++i) {
      const pid_t child = fork();
      if (child == 0) {
        for (int n = 0;; ++n) (void)writeFileAtomically(path, contents[n % 2]);
      }
      QTest::qSleep(5 + 7 * (i % 5));
      QCOMPARE(kill(child, SIGKILL), 0);
      QCOMPARE(waitpid(child, nullptr, 0), child);
      const std::string left = contentOf(path).toStdString();
      QVERIFY(left == contents[0] || left == contents[1]);
      QVERIFY(namesIn(folder).size() <= 2);
      QVERIFY(writeFileAtomically(path, contents[i % 2]).hasValue());
      QCOMPARE(namesIn(folder), QStringList{"a"});
    }
  }

  // The file of a killed program is removed, that of a running one stays.
  void draftsAreRemovedUnlessSomebodyHoldsThem() {
    QTemporaryDir folder;
    const auto path = in(folder, "a"), dead = AtomicSaveFile::hiddenName(path, 1),
               alive = AtomicSaveFile::hiddenName(path, 0);
    for (const auto& file : {path, dead, alive}) QVERIFY(writeFileAtomically(file, "old").hasValue());
    const int held = ::open(alive.c_str(), O_RDONLY);
    QCOMPARE(flock(held, LOCK_EX), 0);
    QVERIFY(writeFileAtomically(path, "new").hasValue());
    QCOMPARE(contentOf(path), QByteArray("new"));
    QVERIFY(std::filesystem::exists(alive) && !std::filesystem::exists(dead));
    ::close(held);
    QVERIFY(writeFileAtomically(path, "newer").hasValue());
    QCOMPARE(contentOf(path), QByteArray("newer"));
    QCOMPARE(namesIn(folder), QStringList{"a"});
  }

  void readOnlyFile() {
    if (geteuid() == 0) QSKIP("the superuser may write everywhere");
    QTemporaryDir folder;
    QVERIFY(writeFileAtomically(in(folder, "a"), "old").hasValue());
    QCOMPARE(chmod(in(folder, "a").c_str(), 0400), 0);
    QCOMPARE(reasonOf(writeFileAtomically(in(folder, "a"), "new")), std::string(std::strerror(EACCES)));
    QCOMPARE(contentOf(in(folder, "a")), QByteArray("old"));
    QCOMPARE(namesIn(folder), QStringList{"a"});
  }

  void missingFolder() {
    QTemporaryDir folder;
    const Status status = writeFileAtomically(in(folder, "no/such/a"), "x");
    QCOMPARE(reasonOf(status), std::string(std::strerror(ENOENT)));
    QCOMPARE(status.error().subject, in(folder, "no/such/a").string());
  }

  void readOnlyFolder() {
    if (geteuid() == 0) QSKIP("the superuser may write everywhere");
    QTemporaryDir folder;
    QVERIFY(writeFileAtomically(in(folder, "a"), "old").hasValue());
    QCOMPARE(chmod(folder.path().toLocal8Bit(), 0500), 0);
    const Status status = writeFileAtomically(in(folder, "a"), "new");
    QCOMPARE(chmod(folder.path().toLocal8Bit(), 0700), 0);
    QCOMPARE(reasonOf(status), std::string(std::strerror(EACCES)));
    QCOMPARE(contentOf(in(folder, "a")), QByteArray("old"));
  }

  void refusesFoldersAndDevices() {
    QTemporaryDir folder;
    QCOMPARE(reasonOf(writeFileAtomically(folder.path().toStdString(), "x")), std::string(std::strerror(EISDIR)));
    QCOMPARE(mkfifo(in(folder, "pipe").c_str(), 0600), 0);
    QCOMPARE(reasonOf(writeFileAtomically(in(folder, "pipe"), "x")), std::string("Not a regular file"));
    QVERIFY(std::filesystem::is_fifo(in(folder, "pipe")));
  }

  // The device receives the bytes and stays a device; a full one reports an error.
  void writesToACharacterDevice() {
    QTemporaryDir folder;
    QVERIFY(writeFileAtomically("/dev/null", std::string(3 << 20, 'x')).hasValue());
    QVERIFY(std::filesystem::is_character_file("/dev/null"));
    std::filesystem::create_symlink("/dev/null", in(folder, "link"));
    QVERIFY(writeFileAtomically(in(folder, "link"), "x").hasValue());
    QVERIFY(std::filesystem::is_symlink(in(folder, "link")));
    QCOMPARE(namesIn(folder), QStringList{"link"});
    QCOMPARE(reasonOf(writeFileAtomically("/dev/full", "x")), std::string(std::strerror(ENOSPC)));
  }

  // A full disk, simulated by a limit on the file size.
  void failingWriteLeavesTheOldFile() {
    QTemporaryDir folder;
    QVERIFY(writeFileAtomically(in(folder, "a"), "old").hasValue());
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    const Status status = writeFileAtomically(in(folder, "a"), std::string(5000, 'x'));
    setrlimit(RLIMIT_FSIZE, &before);
    QCOMPARE(QString::fromStdString(reasonOf(status)), QString(std::strerror(EFBIG)));
    QCOMPARE(contentOf(in(folder, "a")), QByteArray("old"));
    QCOMPARE(namesIn(folder), QStringList{"a"});
  }

  void cancelLeavesTheOldFile() {
    QTemporaryDir folder;
    QVERIFY(writeFileAtomically(in(folder, "a"), "old").hasValue());
    JobState state;
    state.cancelled = true;
    const Status status = writeFileAtomically(in(folder, "a"), "new", Progress(state));
    QVERIFY(!status);
    QCOMPARE(status.error().code, ErrorCode::Cancelled);
    QCOMPARE(contentOf(in(folder, "a")), QByteArray("old"));
    QCOMPARE(namesIn(folder), QStringList{"a"});
  }
};

HANDWHEEL_TEST(AtomicFileTest)
#include "AtomicFileTest.moc"
