# SPDX-License-Identifier: GPL-3.0-or-later
# The jobs that make data: one for each experiment, from the lines in the head of its source, and one scene for
# the generated pair and for each real joint.

# joints(FOLDER): IMPINGE_JOINTS, and for each JOINT_ball and JOINT_socket. A real joint is a sub-folder with a ball and a
# socket mesh under one of these names, the first that is there.
set(ball_names ball femoral_head humeral_head)
set(socket_names socket acetabulum_facing glenoid_facing acetabulum glenoid)
function(joints folder)
  set(found "")
  file(GLOB folders CONFIGURE_DEPENDS "${folder}/*")
  foreach(joint_folder IN LISTS folders)
    cmake_path(GET joint_folder FILENAME joint)
    foreach(part ball socket)
      set(${part} "")
      foreach(name IN LISTS ${part}_names)
        file(GLOB files "${joint_folder}/${name}.[posPOS]*")
        if(files AND NOT ${part})
          list(GET files 0 ${part})
        endif()
      endforeach()
      set(${joint}_${part} "${${part}}" PARENT_SCOPE)
    endforeach()
    if(ball AND socket)
      list(APPEND found ${joint})
    endif()
  endforeach()
  set(IMPINGE_JOINTS "${found}" PARENT_SCOPE)
endfunction()

# side_and_axes(VARIABLE FOLDER): options of scene from an optional subject.json, whose "side" is left or right and whose
# "axes" reads like "+x = patient right, +y = anterior, +z = superior".
function(side_and_axes variable folder)
  set(options "")
  if(EXISTS "${folder}/subject.json")
    file(READ "${folder}/subject.json" subject)
    string(JSON side ERROR_VARIABLE none GET "${subject}" side)
    string(JSON axes ERROR_VARIABLE none GET "${subject}" axes)
    if(side MATCHES "^(left|right)$")
      list(APPEND options --side ${side})
    endif()
    string(REGEX MATCHALL "= (patient )?(right|left|anterior|posterior|superior|inferior)" ends "${axes}")
    list(TRANSFORM ends REPLACE "= (patient )?(.).*" "\\2")
    list(JOIN ends "" ends)
    string(TOUPPER "${ends}" ends)
    if(ends MATCHES "^...$")
      list(APPEND options --axes ${ends})
    endif()
  endif()
  set(${variable} "${options}" PARENT_SCOPE)
endfunction()

set(IMPINGE_JOINTS "")
if(IMPINGE_BONES)
  joints("${IMPINGE_BONES}")
  if(NOT IMPINGE_JOINTS)
    list(JOIN ball_names ", " balls)
    list(JOIN socket_names ", " sockets)
    set(refused "--bones ${IMPINGE_BONES}: no sub-folder holds a ball (${balls}) and a socket (${sockets})")
    file(WRITE "${IMPINGE_GRAPH_DIR}/refused" "${refused}\n") # for experiments/reproduce, unwrapped
    message(FATAL_ERROR "${refused}")
  endif()
endif()

foreach(driver IN LISTS drivers)
  name_of(name "${driver}")
  set(source "${CMAKE_CURRENT_SOURCE_DIR}/${driver}")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
  foreach(key question writes writes-with-bones files files-with-bones bones timing seconds reads)
    tag(${key} "${source}" ${key})
  endforeach()
  if(NOT writes)
    message(FATAL_ERROR "${source} has no line '// @writes NAME...': see experiments/CMakeLists.txt")
  endif()
  words(tables "${writes}")
  list(JOIN files " " files) # one line or several
  words(more_files "${files}")
  words(seconds "${seconds}")
  words(reads "${reads}")
  list(TRANSFORM reads PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  set(bones_arguments "")
  set(bones_files "")
  if(IMPINGE_JOINTS AND (writes-with-bones OR bones STREQUAL "yes"))
    words(more "${writes-with-bones}")
    list(APPEND tables ${more})
    set(bones_arguments --bones "${IMPINGE_BONES}")
    foreach(joint IN LISTS IMPINGE_JOINTS)
      file(GLOB subject CONFIGURE_DEPENDS "${IMPINGE_BONES}/${joint}/subject.json")
      list(APPEND bones_files "${${joint}_ball}" "${${joint}_socket}" ${subject})
      string(REPLACE JOINT ${joint} own_files "${files-with-bones}")
      words(own_files "${own_files}")
      list(APPEND more_files ${own_files})
    endforeach()
  endif()
  set(outputs "")
  foreach(table IN LISTS tables)
    list(APPEND outputs data/${table}.csv data/${table}.json)
  endforeach()
  list(TRANSFORM more_files PREPEND data/)
  list(APPEND outputs ${more_files})
  set(timing_option "")
  if(timing STREQUAL "yes")
    set(timing_option TIMING)
  endif()
  impinge_program(${name} program)
  impinge_job(
    NAME ${name} KIND data TALKS ${timing_option}
    OUTPUTS ${outputs}
    DEPENDS "${program}" ${bones_files} ${reads}
    COMMAND "${program}" --out data --profile ${IMPINGE_PROFILE} ${bones_arguments}
    SECONDS ${seconds}
    ARTEFACTS ${tables}
    QUESTION "${question}")
endforeach()

# impinge_scene(NAME BALL SOCKET OPTION...): the scene program on one joint, into scenes/NAME.
function(impinge_scene name ball socket)
  impinge_job(
    NAME scene-${name} KIND data
    OUTPUTS scenes/${name}/ball.ply scenes/${name}/socket.ply scenes/${name}/gaps.csv
            scenes/${name}/distances.csv scenes/${name}/summary.json
    DEPENDS "${scene_program}" "${ball}" "${socket}"
    COMMAND "${scene_program}" --ball "${ball}" --socket "${socket}" ${ARGN} --out scenes/${name}
    SECONDS 2 2
    ARTEFACTS scene-${name}
    QUESTION "Where is the joint ${name} impinged?")
endfunction()

# The joint in detail, for its picture, and as each of the thesis' two systems has it at 1 degree, for Figures 49 and 50.
set(IMPINGE_SCENES "")
set(IMPINGE_SYSTEMS rsid usid)
function(impinge_scenes name)
  impinge_scene(${name} ${ARGN} --precision 0.5)
  foreach(scheme IN LISTS IMPINGE_SYSTEMS)
    impinge_scene(${name}-${scheme} ${ARGN} --precision 1 --scheme ${scheme})
  endforeach()
  set(IMPINGE_SCENES ${IMPINGE_SCENES} ${name} PARENT_SCOPE)
endfunction()

if(TARGET scene AND TARGET make_pair)
  impinge_program(scene scene_program)
  impinge_program(make_pair pair_program)
  impinge_job(
    NAME generated-pair KIND data
    OUTPUTS scenes/generated/input/ball.ply scenes/generated/input/socket.ply
    DEPENDS "${pair_program}"
    COMMAND "${pair_program}" --faces 12000 --out scenes/generated/input
    SECONDS 1 1
    ARTEFACTS generated-pair
    QUESTION "What does the generated ball-and-socket pair look like?")
  set(pair "${IMPINGE_RESULTS_DIR}/scenes/generated/input")
  # In this pose the bump of the ball is under the socket. Elsewhere the gap is 4 mm, which must not be where colours change:
  # chords of the two meshes would put the ball below and the socket above.
  impinge_scenes(generated "${pair}/ball.ply" "${pair}/socket.ply" --side right --pose abduction=80 --cartilage 3)
  foreach(joint IN LISTS IMPINGE_JOINTS)
    side_and_axes(options "${IMPINGE_BONES}/${joint}")
    impinge_scenes(${joint} "${${joint}_ball}" "${${joint}_socket}" --cartilage 4 ${options})
  endforeach()
endif()

# The stand-ins for the two patients of the thesis: as modelled, and at the end of each motion of Table 11 with the colours
# of Tables 12 and 13 (red within 2 mm, blue beyond 6).
function(impinge_gaps name ball socket)
  impinge_job(
    NAME scene-${name} KIND data
    OUTPUTS scenes/${name}/ball.ply scenes/${name}/socket.ply scenes/${name}/gaps.csv scenes/${name}/summary.json
    DEPENDS "${scene_program}" "${ball}" "${socket}"
    COMMAND "${scene_program}" --ball "${ball}" --socket "${socket}" --outputs gaps ${ARGN} --out scenes/${name}
    SECONDS 1 1
    ARTEFACTS scene-${name}
    QUESTION "Where is the joint ${name} impinged?")
endfunction()

set(IMPINGE_MOTIONS "")
if(TARGET scene AND TARGET make_pair)
  file(STRINGS "${PROJECT_SOURCE_DIR}/analysis/common/thesis_values.csv" recorded REGEX "^table-11,")
  foreach(patient IN ITEMS patient_a:right patient_b:left)
    string(REGEX MATCH "(.*):(.*)" none ${patient})
    set(patient ${CMAKE_MATCH_1})
    set(side ${CMAKE_MATCH_2})
    set(ball "${IMPINGE_RESULTS_DIR}/scenes/${patient}/input/ball.ply")
    set(socket "${IMPINGE_RESULTS_DIR}/scenes/${patient}/input/socket.ply")
    impinge_job(
      NAME hip-${patient} KIND data
      OUTPUTS scenes/${patient}/input/ball.ply scenes/${patient}/input/socket.ply
      DEPENDS "${pair_program}"
      COMMAND "${pair_program}" --hip ${patient} --out scenes/${patient}/input
      SECONDS 1 1
      ARTEFACTS hip-${patient}
      QUESTION "What does the stand-in for the thesis' ${patient} look like?")
    impinge_gaps(${patient} "${ball}" "${socket}" --side ${side} --cartilage 4)
    foreach(line IN LISTS recorded)
      if(line MATCHES "^table-11,([a-z_]+),${patient},([0-9.]+),")
        impinge_gaps(${patient}-${CMAKE_MATCH_1} "${ball}" "${socket}" --side ${side} --cartilage 6
                     --pose ${CMAKE_MATCH_1}=${CMAKE_MATCH_2})
        list(APPEND IMPINGE_MOTIONS ${CMAKE_MATCH_1})
      endif()
    endforeach()
  endforeach()
endif()
set(IMPINGE_SCENES "${IMPINGE_SCENES}" PARENT_SCOPE)
list(REMOVE_DUPLICATES IMPINGE_MOTIONS)
set(IMPINGE_MOTIONS "${IMPINGE_MOTIONS}" PARENT_SCOPE)
set(IMPINGE_JOINTS "${IMPINGE_JOINTS}" PARENT_SCOPE)
