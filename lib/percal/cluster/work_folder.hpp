// The folder that a coordinator and the tasks of a cluster share: lists of what is to be run, and a file for each evaluation that is done.
// Files appear whole or not at all; no locks and no database, which network file systems have badly.    docs/decisions/0022-slurm.md
#pragma once
#include <string>
#include <vector>

#include "percal/store/store.hpp"

namespace percal {

class WorkFolder {
 public:
  // Made where it is not there. Throws IoFailure.
  explicit WorkFolder(std::string path);

  // Of the task-th task of an array, the keys of its evaluations: PATH/todo/ARRAY/TASK
  std::string list_file(const std::string& array, int task) const;
  void write_list(const std::string& array, int task, const std::vector<std::string>& keys) const;
  std::vector<std::string> list(const std::string& array, int task) const;  // none where there is no such list

  // PATH/done/AB/DIGEST.json. Throws IoFailure.
  bool has_result(const std::string& key) const;
  void put_result(const KeyedEvaluation& evaluation) const;
  void remove_result(const std::string& key) const;
  // All that there are, in no order. What is no result is left alone.
  std::vector<KeyedEvaluation> results() const;

  std::string path() const { return path_; }  // absolute
  std::string log_folder() const { return path_ + "/log"; }

 private:
  std::string result_file(const std::string& key) const;
  std::string path_;
};

// The folder of a list: PATH of PATH/todo/ARRAY/TASK. Throws BadInput for another file.
std::string work_folder_of(const std::string& list_file);
// The keys in a list, one a line.
std::vector<std::string> keys_of(const std::string& list);

}  // namespace percal
