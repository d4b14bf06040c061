# SPDX-License-Identifier: BSD-3-Clause
case $- in *i*) echo 'berm desk: cases and runs of this folder in the browser; it prints the address. Files of drive C: /mnt/c' ;; esac
