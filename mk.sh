set -e
cd /work/main
c++ -std=c++20 -O2 -DNDEBUG -ffp-contract=off -I. -I/usr/include/eigen3 -Itesting/haptics/tool -fpch-preprocess $1 -o $2 -Wl,-rpath,/work/main/build/lib build/lib/libpalpate_testing.a /usr/lib/x86_64-linux-gnu/libgmock.a build/lib/libpalpate_tool_oracle.a /usr/lib/x86_64-linux-gnu/libgtest.a build/lib/libpalpate_testing.a testing/haptics/tool/CrossingJudge.cpp build/lib/libpalpate.so /usr/lib/x86_64-linux-gnu/libgmpxx.so -lmpfr -lgmp
