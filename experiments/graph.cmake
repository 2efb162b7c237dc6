# SPDX-License-Identifier: GPL-3.0-or-later
# The one dependency graph: programs -> data -> tables, figures -> verdicts -> report and paper.
#
# impinge_job() declares one node. Ninja decides what runs; experiments/job.py runs one node so that its files
# appear whole or not at all, keep their time stamp when their bytes are the same (so that what follows is not
# made again), and so that nothing else runs beside a timing.

set(IMPINGE_RESULTS_DIR "${PROJECT_SOURCE_DIR}/results" CACHE PATH "Where tables, figures, report and paper go")
set(IMPINGE_PROFILE "quick" CACHE STRING "Size of the experiments: quick or full")
set(IMPINGE_BONES "" CACHE PATH "Folder with one sub-folder a real joint; empty for the generated pair alone")
set_property(CACHE IMPINGE_PROFILE PROPERTY STRINGS quick full)
if(NOT IMPINGE_PROFILE MATCHES "^(quick|full)$")
  message(FATAL_ERROR "IMPINGE_PROFILE is '${IMPINGE_PROFILE}': it must be quick or full")
endif()

execute_process(
  COMMAND "${Python3_EXECUTABLE}" -c "import importlib.util as u, sys; sys.exit(' '.join(m for m in ('numpy', \
'pandas', 'matplotlib', 'vtkmodules') if u.find_spec(m) is None) or 0)"
  ERROR_VARIABLE missing_modules OUTPUT_QUIET ERROR_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE modules_failed)
if(modules_failed)
  message(FATAL_ERROR "${Python3_EXECUTABLE} lacks the modules: ${missing_modules}\n"
                      "Install the packages of experiments/packages, or set Python3_EXECUTABLE.")
endif()

set(IMPINGE_GRAPH_DIR "${PROJECT_BINARY_DIR}/graph" CACHE INTERNAL "State of the graph: jobs, locks, times")
set(IMPINGE_JOB_RUNNER "${CMAKE_CURRENT_LIST_DIR}/job.py" CACHE INTERNAL "Runs one job")

# run_graph.py builds what a job needs of these before it runs any job: no compiler beside a stopwatch.
add_custom_target(programs COMMENT "")
add_custom_target(results COMMENT "")

# impinge_program(TARGET VARIABLE): a copy of the program that changes only when its bytes do, so that a comment
# edited in the library builds again but measures nothing again. VARIABLE receives the path of the copy.
function(impinge_program target variable)
  set(copy "${IMPINGE_GRAPH_DIR}/programs/${target}.kept") # a target's bare name would confuse CMake 3.25
  add_custom_command(
    OUTPUT "${copy}"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${IMPINGE_GRAPH_DIR}/programs"
    COMMAND "${CMAKE_COMMAND}" -E copy_if_different "$<TARGET_FILE:${target}>" "${copy}"
    DEPENDS ${target}
    COMMENT "program ${target}"
    VERBATIM)
  add_custom_target(program-${target} DEPENDS "${copy}")
  add_dependencies(programs program-${target})
  set(${variable} "${copy}" PARENT_SCOPE)
endfunction()

# impinge_script(FILE): a script from npm's registry. Without it everything is built but what needs it, which says so.
function(impinge_script file)
  if(NOT EXISTS "${file}")
    set(why "${file} is missing: run 'npm ci --prefix analysis' in ${PROJECT_SOURCE_DIR}, or experiments/reproduce, which does")
    add_custom_command(OUTPUT "${file}" COMMAND "${CMAKE_COMMAND}" -E echo "${why}" COMMAND "${CMAKE_COMMAND}" -E false VERBATIM)
  endif()
endfunction()

# impinge_job(NAME name KIND data|table|figure|text|verdicts|page|report|paper [TIMING] [TALKS]
#   OUTPUTS file...        relative to the results folder; ARTEFACTS names what a reader calls them
#   DEPENDS file...        absolute, or relative to the results folder
#   COMMAND word...        runs in a fresh folder laid out as the results folder, and writes there
#   TIMING                 runs alone on the machine; TALKS: what it prints is progress that the user sees
#   SECONDS quick full     what it may take on two cores; a run that takes longer says so
#   QUESTION text)
function(impinge_job)
  cmake_parse_arguments(job "TIMING;TALKS" "NAME;KIND;QUESTION" "OUTPUTS;DEPENDS;COMMAND;SECONDS;ARTEFACTS" ${ARGN})
  set(outputs ${job_OUTPUTS})
  list(TRANSFORM outputs PREPEND "${IMPINGE_RESULTS_DIR}/")
  set(depends "")
  foreach(file IN LISTS job_DEPENDS)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY "${IMPINGE_RESULTS_DIR}")
    list(APPEND depends "${file}")
  endforeach()
  set(options --name ${job_NAME} --results "${IMPINGE_RESULTS_DIR}" --state "${IMPINGE_GRAPH_DIR}/${IMPINGE_PROFILE}"
      --lock "${IMPINGE_GRAPH_DIR}/machine.lock")
  if(job_TIMING)
    list(APPEND options --alone)
  endif()
  if(job_TALKS)
    list(APPEND options --talks)
  endif()
  # --only and --why take the name of an artefact: it must say which one.
  get_property(artefacts GLOBAL PROPERTY IMPINGE_ARTEFACTS)
  foreach(artefact IN LISTS job_ARTEFACTS)
    if(artefact IN_LIST artefacts)
      message(FATAL_ERROR "Job ${job_NAME} makes '${artefact}', and so does a job before it: name one of them otherwise")
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY IMPINGE_ARTEFACTS ${job_ARTEFACTS})

  add_custom_command(
    OUTPUT ${outputs}
    COMMAND "${Python3_EXECUTABLE}" "${IMPINGE_JOB_RUNNER}" ${options} --outputs ${job_OUTPUTS} -- ${job_COMMAND}
    DEPENDS ${depends}
    COMMENT "job ${job_NAME}"
    VERBATIM)
  add_custom_target(result-${job_NAME} DEPENDS ${outputs})
  add_dependencies(results result-${job_NAME})

  list(JOIN job_SECONDS ", " budget)
  string(TOLOWER ${job_TIMING} timing)
  string(REPLACE "\"" "\\\"" question "${job_QUESTION}")
  foreach(list IN ITEMS ARTEFACTS OUTPUTS DEPENDS COMMAND)
    list(JOIN job_${list} [[", "]] ${list})
  endforeach()
  string(CONFIGURE [[{"name": "@job_NAME@", "kind": "@job_KIND@", "budget": [@budget@], "timing": @timing@, "question": "@question@",
 "artefacts": ["@ARTEFACTS@"], "outputs": ["@OUTPUTS@"], "depends": ["@DEPENDS@"], "command": ["@COMMAND@"]}]] job @ONLY)
  string(REPLACE "${PROJECT_SOURCE_DIR}/" "" job "${job}")
  set_property(GLOBAL APPEND PROPERTY IMPINGE_JOBS "${job}")
  set_property(GLOBAL APPEND PROPERTY IMPINGE_OUTPUTS ${job_OUTPUTS})
endfunction()

# impinge_left_out(PART WHAT): experiments/packages has a list of PART's packages, and not all are installed. Said in one line.
function(impinge_left_out part what)
  set_property(GLOBAL APPEND PROPERTY IMPINGE_LEFT_OUT
               "${what} is left out: experiments/reproduce --only ${part} installs its packages and makes it")
endfunction()

# Called once, after the last job of the last folder.
function(impinge_write_graph)
  get_property(jobs GLOBAL PROPERTY IMPINGE_JOBS)
  list(JOIN jobs ",\n" jobs)
  file(CONFIGURE OUTPUT "${IMPINGE_GRAPH_DIR}/jobs.json" CONTENT "[${jobs}]\n" @ONLY) # analysis/common/jobs.py reads it
  # The same graph for asking only: with build.ninja itself, a dry run stops at "would configure again".
  file(WRITE "${IMPINGE_GRAPH_DIR}/ask.ninja" "include build.ninja\n")
  file(WRITE "${IMPINGE_GRAPH_DIR}/settings"
       "${IMPINGE_RESULTS_DIR}\n${IMPINGE_PROFILE}\n${IMPINGE_BONES}\n${IMPINGE_PARTS}\n")
  get_property(left_out GLOBAL PROPERTY IMPINGE_LEFT_OUT)
  list(TRANSFORM left_out APPEND "\n")
  list(JOIN left_out "" left_out)
  file(WRITE "${IMPINGE_GRAPH_DIR}/left_out" "${left_out}")
endfunction()
