#include "percal/store/store.hpp"

#include <sqlite3.h>

#include <cassert>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <thread>

#include "percal/base/error.hpp"
#include "percal/base/inputs.hpp"
#include "percal/store/taken_copy.hpp"

namespace percal {
namespace {

constexpr int application_id = 0x50434c53;  // "PCLS": tells a store from other SQLite files
constexpr int schema_version = 1;
constexpr int busy_milliseconds = 60000;  // how long another process may hold the write lock

constexpr const char* schema = R"sql(
  CREATE TABLE evaluations (
    key TEXT PRIMARY KEY NOT NULL,
    outcome TEXT NOT NULL,
    payload TEXT NOT NULL,
    cpu_seconds REAL NOT NULL,
    created TEXT NOT NULL
  ) WITHOUT ROWID;
)sql";

// Came later, within the same schema: a store that was made without it gets it when it is opened.
constexpr const char* notes_schema =
    "CREATE TABLE IF NOT EXISTS notes (name TEXT PRIMARY KEY NOT NULL, text TEXT NOT NULL) WITHOUT ROWID";

}  // namespace

namespace sqlite {

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
};
struct FinalizeStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;
using Statement = std::unique_ptr<sqlite3_stmt, FinalizeStatement>;

// Leaves a statement ready for its next use, whatever happens.
struct Reset {
  explicit Reset(const Statement& statement) : statement(statement) {}
  ~Reset() {
    sqlite3_reset(statement.get());
    sqlite3_clear_bindings(statement.get());
  }
  const Statement& statement;
};

}  // namespace sqlite

using sqlite::Database, sqlite::Reset, sqlite::Statement;

// One connection, used under the mutex.
struct Store::Connection {
  std::unique_ptr<TakenCopy> copy;  // of a store that is not to be touched; goes after the database is closed
  std::string path;                 // for messages
  std::string file;                 // what is opened
  mutable std::mutex mutex;
  Database database;
  std::unique_ptr<Claims> claims;  // of a store that is opened, not of a copy
  Statement select, select_from, insert, replace, count, select_note, insert_note;

  [[noreturn]] void fail_to_read() const {
    const int result = sqlite3_errcode(database.get());
    const bool is_foreign = result == SQLITE_NOTADB || result == SQLITE_ERROR;  // ERROR: a table or column is not there
    fail(is_foreign ? "is not a store of this program" : "cannot read the store");
  }

  [[noreturn]] void fail(const std::string& what) const {
    const char* reason = database ? sqlite3_errmsg(database.get()) : "out of memory";
    throw IoFailure(path + ": " + what + ": " + reason);
  }

  void execute(const std::string& sql, const std::string& purpose) const {
    if (sqlite3_exec(database.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail(purpose);
  }

  Statement prepare(const char* sql) const {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v3(database.get(), sql, -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr) != SQLITE_OK) {
      fail_to_read();
    }
    return Statement(statement);
  }

  int whole_number(const char* sql) const {
    const Statement statement = prepare(sql);
    if (sqlite3_step(statement.get()) != SQLITE_ROW) fail_to_read();
    return sqlite3_column_int(statement.get(), 0);
  }

  void roll_back() const { sqlite3_exec(database.get(), "ROLLBACK", nullptr, nullptr, nullptr); }

  // Somebody else's file, or one newer than this program, is refused before anything is written to it.
  void refuse_foreign() const {
    execute("BEGIN", "cannot open the store");  // one snapshot: another process may be making the store right now
    try {
      is_new();
    } catch (...) {
      roll_back();
      throw;
    }
    roll_back();
  }

  // True where the file has no content yet. Throws where it is no store. Wants a transaction around it.
  bool is_new() const {
    const int id = whole_number("PRAGMA application_id"), version = whole_number("PRAGMA user_version");
    const bool empty = whole_number("SELECT count(*) FROM sqlite_master") == 0;
    if (id == 0 && version == 0 && empty) return true;
    if (id != application_id) throw IoFailure(path + ": is a database of another program, not a store");
    if (version != schema_version) {
      throw IoFailure(path + ": has schema " + std::to_string(version) + ", this program reads schema " +
                      std::to_string(schema_version) + "; give another file with --store");
    }
    return false;
  }

  void open() {
    sqlite3* raw = nullptr;
    const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
    const int result = sqlite3_open_v2(file.c_str(), &raw, flags, nullptr);
    database.reset(raw);
    if (result != SQLITE_OK) fail("cannot open the store");
    sqlite3_busy_timeout(database.get(), busy_milliseconds);
    if (sqlite3_db_readonly(database.get(), "main") == 1) throw IoFailure(path + ": cannot be written");
  }

  // WAL lets others read while one writes. Switching to it needs the file for oneself, and does not wait for it by
  // itself.
  void switch_to_wal() const {
    constexpr auto pause = std::chrono::milliseconds(5);
    for (int waited = 0;; waited += 5) {
      const Statement statement = prepare("PRAGMA journal_mode = WAL");
      const int result = sqlite3_step(statement.get());
      if (result == SQLITE_ROW) {
        const std::string mode = reinterpret_cast<const char*>(sqlite3_column_text(statement.get(), 0));
        if (mode == "wal") return;
        throw IoFailure(path + ": this file system cannot hold a store (journal mode " + mode + ")");
      }
      if (result != SQLITE_BUSY || waited >= busy_milliseconds) fail("cannot open the store");
      std::this_thread::sleep_for(pause);
    }
  }

  // The lock makes one of several processes that open a new store at once its maker; the others then find it made.
  void create_if_new() const {
    execute("BEGIN IMMEDIATE", "cannot open the store");
    try {
      if (is_new()) {
        execute(schema, "cannot create the store");
        execute("PRAGMA application_id = " + std::to_string(application_id), "cannot create the store");
        execute("PRAGMA user_version = " + std::to_string(schema_version), "cannot create the store");
      }
      execute(notes_schema, "cannot create the store");
      execute("COMMIT", "cannot create the store");
    } catch (...) {
      roll_back();
      throw;
    }
  }

  void prepare_statements() {
    select = prepare("SELECT outcome, payload, cpu_seconds FROM evaluations WHERE key = ?1");
    const std::string insert_or =
        "INSERT INTO evaluations (key, outcome, payload, cpu_seconds, created)"
        " VALUES (?1, ?2, ?3, ?4, strftime('%Y-%m-%dT%H:%M:%SZ', 'now')) ON CONFLICT (key) DO ";
    insert = prepare((insert_or + "NOTHING").c_str());
    replace = prepare((insert_or + "UPDATE SET outcome = excluded.outcome, payload = excluded.payload,"
                                   " cpu_seconds = excluded.cpu_seconds, created = excluded.created")
                          .c_str());
    select_from = prepare(
        "SELECT outcome, payload, cpu_seconds, key FROM evaluations WHERE key >= ?1 AND substr(key, 1, length(?1)) = ?1"
        " ORDER BY key");
    count = prepare("SELECT count(*) FROM evaluations");
    select_note = prepare("SELECT text FROM notes WHERE name = ?1");
    insert_note = prepare("INSERT INTO notes (name, text) VALUES (?1, ?2) ON CONFLICT (name) DO NOTHING");
  }

  // One statement is one transaction: it takes the write lock, waiting for it, and is synced to the disk before step returns.
  void write(const Statement& statement, const std::string& key, const StoredEvaluation& evaluation) const {
    const Reset reset(statement);
    bind(statement, 1, key);
    bind(statement, 2, evaluation.outcome);
    bind(statement, 3, evaluation.payload);
    sqlite3_bind_double(statement.get(), 4, evaluation.cpu_seconds);
    if (sqlite3_step(statement.get()) != SQLITE_DONE) fail("cannot write to the store");
  }

  void bind(const Statement& statement, int index, const std::string& text) const {
    if (sqlite3_bind_text64(statement.get(), index, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8) !=
        SQLITE_OK) {
      fail("cannot use the text of an evaluation");
    }
  }
};

namespace {

std::string text_at(const Statement& statement, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement.get(), column));
  return text ? std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement.get(), column)))
              : std::string();
}

// SQLite gives some names a meaning of their own (":memory:", ""); a path from the root has none.
std::string full_path(const std::string& path) {
  if (path.empty() || path.find('\0') != std::string::npos)
    throw IoFailure("the name of the store may not be empty or hold a zero byte");
  std::error_code error;
  const auto full = std::filesystem::absolute(path, error);
  if (error) throw IoFailure(path + ": " + error.message());
  std::filesystem::create_directories(full.parent_path(), error);
  if (error)
    throw IoFailure(full.parent_path().string() + ": cannot create the folder of the store: " + error.message());
  return full.string();
}

}  // namespace

Store::Store() : connection_(std::make_unique<Connection>()) {}

Store::Store(const std::string& path) : Store() {
  connection_->path = connection_->file = full_path(path);
  open();
  connection_->claims = std::make_unique<Claims>(std::filesystem::weakly_canonical(connection_->file).string());
  remember_input(connection_->file);  // nothing that a command writes may replace it either
}

Store Store::copy_of(const std::string& path) {
  Store store;
  store.connection_->path = path;
  store.connection_->copy = std::make_unique<TakenCopy>(path);
  store.connection_->file = store.connection_->copy->file();
  store.open();
  return store;
}

void Store::open() {
  connection_->open();
  connection_->refuse_foreign();
  connection_->switch_to_wal();
  connection_->execute("PRAGMA synchronous = FULL", "cannot open the store");
  connection_->create_if_new();
  connection_->prepare_statements();
}

Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

std::optional<StoredEvaluation> Store::find(const std::string& key) const {
  const std::lock_guard lock(connection_->mutex);
  const auto& select = connection_->select;
  const Reset reset(select);
  connection_->bind(select, 1, key);
  const int result = sqlite3_step(select.get());
  if (result == SQLITE_DONE) return std::nullopt;
  if (result != SQLITE_ROW) connection_->fail_to_read();
  return StoredEvaluation{text_at(select, 0), text_at(select, 1), sqlite3_column_double(select.get(), 2)};
}

std::optional<Claims::Claim> Store::claim(const std::string& key) const {
  assert(connection_->claims);
  return connection_->claims->claim(key);
}

std::vector<KeyedEvaluation> Store::with_prefix(const std::string& prefix) const {
  const std::lock_guard lock(connection_->mutex);
  const auto& select = connection_->select_from;
  const Reset reset(select);
  connection_->bind(select, 1, prefix);
  std::vector<KeyedEvaluation> found;
  int result;
  while ((result = sqlite3_step(select.get())) == SQLITE_ROW)
    found.push_back(
        {text_at(select, 3), {text_at(select, 0), text_at(select, 1), sqlite3_column_double(select.get(), 2)}});
  if (result != SQLITE_DONE) connection_->fail_to_read();
  return found;
}

void Store::put(const std::string& key, const StoredEvaluation& evaluation) {
  const std::lock_guard lock(connection_->mutex);
  connection_->write(connection_->insert, key, evaluation);
}

void Store::replace(const std::string& key, const StoredEvaluation& evaluation) {
  const std::lock_guard lock(connection_->mutex);
  connection_->write(connection_->replace, key, evaluation);
}

long Store::size() const {
  const std::lock_guard lock(connection_->mutex);
  const Reset reset(connection_->count);
  if (sqlite3_step(connection_->count.get()) != SQLITE_ROW) connection_->fail_to_read();
  return static_cast<long>(sqlite3_column_int64(connection_->count.get(), 0));
}

std::optional<std::string> Store::note(const std::string& name) const {
  const std::lock_guard lock(connection_->mutex);
  const auto& select = connection_->select_note;
  const Reset reset(select);
  connection_->bind(select, 1, name);
  const int result = sqlite3_step(select.get());
  if (result == SQLITE_DONE) return std::nullopt;
  if (result != SQLITE_ROW) connection_->fail_to_read();
  return text_at(select, 0);
}

void Store::put_note(const std::string& name, const std::string& text) {
  const std::lock_guard lock(connection_->mutex);
  const auto& insert = connection_->insert_note;
  const Reset reset(insert);
  connection_->bind(insert, 1, name);
  connection_->bind(insert, 2, text);
  if (sqlite3_step(insert.get()) != SQLITE_DONE) connection_->fail("cannot write to the store");
}

std::vector<std::pair<std::string, std::string>> Store::notes() const {
  const std::lock_guard lock(connection_->mutex);
  const Statement select = connection_->prepare("SELECT name, text FROM notes ORDER BY name");
  std::vector<std::pair<std::string, std::string>> found;
  int result;
  while ((result = sqlite3_step(select.get())) == SQLITE_ROW)
    found.emplace_back(text_at(select, 0), text_at(select, 1));
  if (result != SQLITE_DONE) connection_->fail_to_read();
  return found;
}

long Store::take_in(const Store& other) {
  const std::vector<KeyedEvaluation> evaluations = other.with_prefix("");
  const std::vector<std::pair<std::string, std::string>> notes = other.notes();
  const long before = size();
  connection_->execute("BEGIN IMMEDIATE", "cannot write to the store");
  try {
    for (const auto& [key, evaluation] : evaluations) put(key, evaluation);
    for (const auto& [name, text] : notes) put_note(name, text);
    connection_->execute("COMMIT", "cannot write to the store");
  } catch (...) {
    connection_->roll_back();
    throw;
  }
  return size() - before;
}

const std::string& Store::path() const { return connection_->path; }

std::string default_store_path() {
  const auto folder = [](const char* variable) -> std::filesystem::path {
    const char* value = std::getenv(variable);
    return value && std::filesystem::path(value).is_absolute() ? value : "";
  };
  constexpr const char* name = "percal.store";
  if (const auto cache = folder("XDG_CACHE_HOME"); !cache.empty()) return (cache / "percal" / name).string();
  if (const auto home = folder("HOME"); !home.empty()) return (home / ".cache" / "percal" / name).string();
  return name;
}

}  // namespace percal
