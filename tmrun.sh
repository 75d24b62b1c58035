cd /tmp/scr; echo $$ >pid
export CRUMPLE_DATA=/work/wt/screen TERM=screen-256color XDG_STATE_HOME=/tmp/scr/state LC_ALL=C.UTF-8 
exec /work/wt/screen/build/crumple
