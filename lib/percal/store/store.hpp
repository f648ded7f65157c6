// Finished evaluations on disk (SQLite, WAL), keyed by the canonical text of a dimensionless problem. What is in the
// store is never computed again; what was killed half-way is not in it.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "percal/store/claims.hpp"

namespace percal {

struct StoredEvaluation {
  std::string outcome;     // "stopped", "passed through", ...: failures are stored as failures
  std::string payload;     // JSON text of the observation
  double cpu_seconds = 0;  // what it cost
  bool operator==(const StoredEvaluation&) const = default;
};

struct KeyedEvaluation {
  std::string key;
  StoredEvaluation evaluation;
};

// Safe to use from several threads of one process and from several processes on one machine. Not for network file
// systems.
class Store {
 public:
  // Opens or creates. Throws IoFailure (unwritable folder, not a store, a newer schema).
  explicit Store(const std::string& path);
  // Another store as it stands, which is neither locked nor touched and may lie where nobody can write: a copy of it in a temporary
  // folder, that goes with the object. Throws IoFailure (no store; still being written to).
  static Store copy_of(const std::string& path);
  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;

  std::optional<StoredEvaluation> find(const std::string& key) const;
  // Durable when it returns. An existing row with this key stays as it is. Throws IoFailure (disk full).
  void put(const std::string& key, const StoredEvaluation& evaluation);
  // The same in place of what is there: an evaluation that knows more.
  void replace(const std::string& key, const StoredEvaluation& evaluation);
  // On the work for a key, as long as it is alive; nothing where another thread or process is at it. Who gets one looks into the
  // store again, since the work may just have been done.
  std::optional<Claims::Claim> claim(const std::string& key) const;
  // Those whose key begins with `prefix`, in the order of the keys' bytes.
  std::vector<KeyedEvaluation> with_prefix(const std::string& prefix) const;
  long size() const;

  // A text kept under a name, for decisions that a job must find again as they were. What is there stays: the first writer wins.
  // Durable when it returns. Throws IoFailure (disk full).
  std::optional<std::string> note(const std::string& name) const;
  void put_note(const std::string& name, const std::string& text);

  // Takes in what another store has and this one has not, evaluations and notes; what is here stays. All of it or none:
  // one transaction, durable when it returns. Returns how many evaluations were new. Throws IoFailure.
  long take_in(const Store& other);

  const std::string& path() const;

 private:
  Store();
  void open();
  std::vector<std::pair<std::string, std::string>> notes() const;

  struct Connection;
  std::unique_ptr<Connection> connection_;
};

// percal.store in the user's cache folder: $XDG_CACHE_HOME/percal, else $HOME/.cache/percal, else the current folder.
std::string default_store_path();

}  // namespace percal
